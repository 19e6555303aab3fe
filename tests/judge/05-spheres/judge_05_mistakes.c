// Known mistakes of lab 05's intersections (see judge_05_mistakes.h).
#include "judge_05_mistakes.h"

#include <float.h>
#include <math.h>

// ---- Mistakes of nearest_root ------------------------------------------------------------------

static float entry_at_t_min(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near >= job.t_min ? t_near : t_far > job.t_min ? t_far : INFINITY;
}

// More than what lies closest beyond t_min among the inputs, and less than all else.
static float hair_beyond(RootJob job)
{
    return job.t_min + 1e-5f * fmaxf(job.t_min, 1);
}

static float beyond_by_hair(RootJob job, float t_near, float t_far)
{
    const float limit = hair_beyond(job);
    return job.radius > 0 && t_near > limit ? t_near : t_far > limit ? t_far : INFINITY;
}

static float entry_by_hair(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near > hair_beyond(job) ? t_near
           : t_far > job.t_min                         ? t_far
                                                       : INFINITY;
}

static float exit_unasked(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near > job.t_min ? t_near : t_far;
}

static float part_begins(RootJob job, float t_near, float t_far)
{
    return t_far <= job.t_min ? INFINITY : job.radius < 0 ? t_far : fmaxf(t_near, job.t_min);
}

static float usual_root(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near > job.t_min ? t_near : t_far > job.t_min ? t_far : INFINITY;
}

static const Misses largest_float = {FLT_MAX, FLT_MAX}, zero = {0, 0},
                    root_of_negative = {NAN, INFINITY};

// ---- Mistakes of the other two ------------------------------------------------------------------

static double disc_of(double b, double c2, double radius)
{
    return b * b - (c2 - radius * radius);
}

static Quadratic b_turned(double b, double c2, double radius)
{
    return (Quadratic){-b, disc_of(b, c2, radius)};
}

static Quadratic both_undivided(double b, double c2, double radius)
{
    return (Quadratic){2 * b, 4 * disc_of(b, c2, radius)};
}

static Quadratic disc_halved(double b, double c2, double radius)
{
    return (Quadratic){b, 2 * disc_of(b, c2, radius)};
}

static Quadratic four_times_c(double b, double c2, double radius)
{
    return (Quadratic){b, b * b - 4 * (c2 - radius * radius)};
}

static Quadratic radius_as_it_is(double b, double c2, double radius)
{
    return (Quadratic){b, b * b - (c2 - radius)};
}

static Quadratic radius_less_way(double b, double c2, double radius)
{
    const double half = radius - sqrt(fmax(c2 - b * b, 0));
    return (Quadratic){b, half * half};
}

static Quadratic disc_turned(double b, double c2, double radius)
{
    return (Quadratic){b, -disc_of(b, c2, radius)};
}

// ---- All of them --------------------------------------------------------------------------------

const RootMistake root_mistakes_05[N_ROOT_MISTAKES] = {
    {.cause = {0}},
    {{.says = "where disc is 0 the ray touches the sphere, and that is a hit"},
     .touching_missed = 1},
    {{.says = "that is the farther root, where the ray leaves the sphere"},
     .rules = {.farther_root = 1}},
    {{.says = "that is not beyond t_min"}, .rules = {.any_distance = 1}},
    {{.says = "a sphere with a negative radius is seen from inside"},
     .rules = {.negative_radius_missed = 1}},
    {{.says = "from inside the second root is the hit: b + sqrt(disc)"},
     .rules = {.inside_is_miss = 1}},
    {{.says = "a negative radius means that only the farther root counts"},
     .rules = {.radius_sign_ignored = 1}},
    {{.says = "where the radius is negative the farther root counts beyond t_min only, too"},
     .rules = {.negative_radius_always = 1}},
    {{.says = "t_min is the ray's, and need not be 0"}, .rules = {.t_min_zero = 1}},
    {{.says = "t_min itself does not count"}, .t_min_counts = 1},
    {{.says = "an entry at t_min itself does not count"}, .root = entry_at_t_min},
    {{.says = "a hit beyond t_min by however little counts: no epsilon"}, .root = beyond_by_hair},
    {{.says = "an entry beyond t_min by however little counts: no epsilon"}, .root = entry_by_hair},
    {{.says = "the exit counts beyond t_min only, too"}, .root = exit_unasked},
    {{.says = "from inside the hit is where the ray leaves the sphere, not t_min"},
     .root = part_begins},
    {{.says = "where nothing is hit INFINITY is to be returned, not the largest float"},
     .root = usual_root,
     .misses = &largest_float},
    {{.says = "a negative disc has no root: it is a miss, to be found before sqrt() makes NaN"},
     .root = usual_root,
     .misses = &root_of_negative},
    {{.says = "where nothing is hit INFINITY is to be returned, not 0"},
     .root = usual_root,
     .misses = &zero},
    {{.says = "b has the wrong sign: what is ahead is taken for what is behind"},
     .quadratic = b_turned},
    {{.says = "the formula with 2 b divides by 2 in the end: both roots are twice as far"},
     .quadratic = both_undivided},
    {{.says = "disc is twice as large: with 2 b for b it is divided by 4"},
     .quadratic = disc_halved},
    {{.says = "with half of the equation's b the discriminant is b² - c, not b² - 4 c"},
     .quadratic = four_times_c},
    {{.says = "the radius is not squared"}, .quadratic = radius_as_it_is},
    {{.says = "the square of r - |l| is never negative: the difference is that of squares"},
     .quadratic = radius_less_way},
    {{.says = "disc has the wrong sign"}, .quadratic = disc_turned},
    {{.says = "the centre is behind the eye, which does not matter where the eye is inside"},
     .rules = {.centre_behind_missed = 1}},
    {{.says = "the digits are lost: the textbook's form, or one like it, which squares before it "
              "subtracts"},
     .is_textbook = 1},
    {{.says = "near the scene's origin hits are right, far from it their digits are lost: subtract "
              "the eye first, and go on with the difference only"},
     .is_lost_afar = 1},
    {{.says = "other hits are right, and nothing but a negative disc and t_min makes a miss"},
     .is_missed = 1},
};
