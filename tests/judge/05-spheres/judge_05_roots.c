// Lab 05: nearest_root, intersect_textbook and intersect_sphere on their inputs. See judge_05.h;
// judge_05_shading.c is the sibling.
#include "judge_05.h"

#include "message.h"
#include "oracle3d.h"
#include "words.h"

#include <float.h>
#include <math.h>

static const OracleRules3D right = {0};

// What an answer to nearest_root with a mistake returns.
typedef float MistakenRoot(RootJob job, float t_near, float t_far);

// What an answer to the other two hands to nearest_root.
typedef struct Quadratic {
    double b, disc;
} Quadratic;
typedef Quadratic MistakenQuadratic(double b, double c2, double radius);

// A known mistake, and what is said about it; number 0 is none.
typedef struct RuleMistake {
    Cause cause;
    OracleRules3D rules;
    MistakenRoot *root;            // nearest_root only;
    const struct Misses *misses;   // right ones where it is NULL
    MistakenQuadratic *quadratic;  // the other two only
    int touching_missed;           // no hit where disc is 0
    int t_min_counts;              // nearest_root: a hit at t_min itself
    int is_textbook;               // intersect_sphere in the textbook's form
    int is_lost_afar;              // far from the scene's origin anything, and all else is right
    int is_missed;                 // some hits are none, and all else is right
} RuleMistake;

// ---- Mistakes of nearest_root --------------------------------------------------------------------

static float entry_at_t_min(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near >= job.t_min ? t_near : t_far > job.t_min ? t_far : INFINITY;
}

static float exit_unasked(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near > job.t_min ? t_near : t_far;
}

static float exit_beyond_0(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near > job.t_min ? t_near : t_far > 0 ? t_far : INFINITY;
}

static float part_begins(RootJob job, float t_near, float t_far)
{
    return t_far <= job.t_min ? INFINITY : job.radius < 0 ? t_far : fmaxf(t_near, job.t_min);
}

static float usual_root(RootJob job, float t_near, float t_far)
{
    return job.radius > 0 && t_near > job.t_min ? t_near : t_far > job.t_min ? t_far : INFINITY;
}

// What is returned for a negative disc, and where no root is beyond t_min.
typedef struct Misses {
    float by_disc, by_t_min;
} Misses;

static const Misses misses = {INFINITY, INFINITY};
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

static const RuleMistake root_mistakes[] = {
    {.cause = {0}},
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
    {{.says = "the exit counts beyond t_min only, too"}, .root = exit_unasked},
    {{.says = "the exit counts beyond t_min, not beyond 0"}, .root = exit_beyond_0},
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
    {{.says = "where disc is 0 the ray touches the sphere, and that is a hit"},
     .touching_missed = 1},
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

// ---- nearest_root -------------------------------------------------------------------------------

// The roots, on a ray of their own: the sphere's centre is at distance b, half a chord of it is the
// radius. What nearest_root gets is exact; its root is not quite.
static OracleRoot expected_root(RootJob job, const OracleRules3D *rules)
{
    const float half_chord = sqrtf(job.disc);
    const Sphere sphere = {job.b, 0, 0, job.radius < 0 ? -half_chord : half_chord};
    OracleRay ray = {.direction = {1, 0, 0}, .t_min = job.t_min};
    OracleRoot miss = {.t = INFINITY};
    return job.disc < 0 ? miss : oracle3d_root(sphere, &ray, ORACLE_PROJECTION, rules);
}

static int is_miss(float found)
{
    return isinf(found) && found > 0;
}

static int is_right_root(const OracleRoot *root, float found)
{
    if (is_miss(found)) {
        return !root->is_certain;
    }
    return root->is_possible && found >= root->t_low && found <= root->t_high;
}

// Where disc is 0, all is exact in float, too: the one root is b, and a hit beyond t_min.
static int touches(RootJob job, const RuleMistake *mistake)
{
    const OracleRules3D *rules = &mistake->rules;
    const int is_negative = job.radius < 0;
    const float limit = rules->t_min_zero ? 0 : job.t_min;
    if (mistake->touching_missed || (rules->centre_behind_missed && job.b < 0) ||
        (is_negative && (rules->negative_radius_missed || rules->inside_is_miss))) {
        return 0;
    }
    return job.b > limit || rules->any_distance || (mistake->t_min_counts && job.b == limit) ||
           (is_negative && rules->negative_radius_always);
}

// Of a disc and a b that are exact the roots are, but for the rounding of a root and a sum.
static int is_mistaken_root(RootJob job, const RuleMistake *mistake, float found)
{
    const Misses *miss = mistake->misses != NULL ? mistake->misses : &misses;
    const float half_chord = sqrtf(fmaxf(job.disc, 0));
    const float root = mistake->root(job, job.b - half_chord, job.b + half_chord);
    const float t = job.disc < 0 ? miss->by_disc : isinf(root) ? miss->by_t_min : root;
    return (isnan(t) && isnan(found)) || t == found ||
           fabsf(found - t) <= 4 * FLT_EPSILON * (fabsf(job.b) + half_chord);
}

static int root_agrees(const void *pointer, int i, const void *answers, int number)
{
    const RootJob job = ((const Job05 *)pointer)->roots[i];
    const RuleMistake *mistake = &root_mistakes[number];
    const float found = ((const float *)answers)[i];
    if (mistake->quadratic != NULL || mistake->is_lost_afar) {
        return 0;  // of the other two
    }
    if (mistake->is_missed && is_miss(found)) {
        return 1;
    }
    if (mistake->root != NULL) {
        return is_mistaken_root(job, mistake, found);
    }
    if (job.disc == 0) {
        return touches(job, mistake) ? found == job.b : is_miss(found);
    }
    const OracleRoot root = expected_root(job, &mistake->rules);
    return is_right_root(&root, found);
}

// Where hits are missed, others must be found: else the cause is another.
static int root_shows(const void *job, Range range, const void *answers, int mistake)
{
    int n_hits = 0;
    for (int i = 0; i < range.n; i++) {
        const int input = range_at(range, i);
        n_hits += !is_miss(((const float *)answers)[input]) && root_agrees(job, input, answers, 0);
    }
    return !root_mistakes[mistake].is_missed || n_hits > 0;
}

static char *describe_root(const void *pointer, int i, const void *answers)
{
    const RootJob job = ((const Job05 *)pointer)->roots[i];
    const double expected = job.disc != 0                     ? expected_root(job, &right).t
                            : touches(job, &root_mistakes[0]) ? (double)job.b
                                                              : (double)INFINITY;
    return message_new("b %g, disc %g, radius %g, t_min %.9g: found %.9g, expected %.9g", job.b,
                       job.disc, job.radius, job.t_min, ((const float *)answers)[i], expected);
}

const Function nearest_root_05 = {"roots",
                                  3 * N_ROOTS,
                                  sizeof(float),
                                  .describe = describe_root,
                                  .agrees = root_agrees,
                                  .shows = root_shows,
                                  .counted = "inputs",
                                  MISTAKES(root_mistakes)};

// ---- intersect_textbook, intersect_sphere -------------------------------------------------------

static OracleRoot expected_hit(const SphereRayJob *job, OracleForm form, const OracleRules3D *rules)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    return oracle3d_root(job->sphere, &ray, form, rules);
}

int touches_exactly_05(const SphereRayJob *job)
{
    const double x = (double)job->sphere.x - job->origin.x;
    const double y = (double)job->sphere.y - job->origin.y;
    return job->direction.x == 0 && job->direction.y == 0 &&
           x * x + y * y == (double)job->sphere.radius * job->sphere.radius;
}

// How far the roots of a mistaken quadratic may be off in float, and its disc, both as a share.
#define MISTAKEN_ERROR 1e-4
#define MISTAKEN_DISC_ERROR 0x1p-18

static int is_near_share(double found, double expected, double size)
{
    return found == expected || fabs(found - expected) <= MISTAKEN_ERROR * size;
}

// Does an answer come of b and disc with a mistake?
static int is_mistaken_hit(const SphereRayJob *job, MistakenQuadratic *mistaken, float found)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    const OracleVector centre = {job->sphere.x, job->sphere.y, job->sphere.z};
    const OracleVector c = vector_minus(centre, ray.origin);
    const double b = vector_dot(c, ray.direction), c2 = vector_dot(c, c);
    const Quadratic in = mistaken(b, c2, job->sphere.radius);
    const double doubt = MISTAKEN_DISC_ERROR * (b * b + c2);
    const double half = sqrt(fmax(in.disc, 0)), t_near = in.b - half, t_far = in.b + half;
    if (fabs(in.disc) <= doubt) {
        // Float may find it negative or not: the roots are near b, or there are none.
        return is_miss(found) || fabs(found - in.b) <= 2 * sqrt(doubt);
    }
    const double t = in.disc < 0                                     ? (double)INFINITY
                     : job->sphere.radius > 0 && t_near > job->t_min ? t_near
                     : t_far > job->t_min                            ? t_far
                                                                     : (double)INFINITY;
    return is_near_share(found, t, fabs(in.b) + half);
}

// Is the eye far from the scene's origin?
static int is_afar(const SphereRayJob *job)
{
    return fabsf(job->origin.x) > 1000;
}

static int sphere_agrees(const SphereRayJob *job, OracleForm form, const RuleMistake *mistake,
                         float found)
{
    if (mistake->root != NULL) {
        return 0;  // of nearest_root
    }
    if (mistake->quadratic != NULL) {
        return is_mistaken_hit(job, mistake->quadratic, found);
    }
    if (mistake->is_lost_afar && is_afar(job)) {
        return 1;
    }
    if (touches_exactly_05(job) && (mistake == root_mistakes || mistake->touching_missed)) {
        return mistake->touching_missed ? is_miss(found) : found == job->sphere.z - job->origin.z;
    }
    const OracleRoot root = expected_hit(job, form, &mistake->rules);
    return (mistake->is_missed && is_miss(found)) || is_right_root(&root, found);
}

static int textbook_agrees(const void *job, int i, const void *answers, int mistake)
{
    return sphere_agrees(&((const Job05 *)job)->textbook[i], ORACLE_TEXTBOOK,
                         &root_mistakes[mistake], ((const float *)answers)[i]);
}

static int projection_agrees(const void *job, int i, const void *answers, int number)
{
    const RuleMistake *mistake = &root_mistakes[number];
    return sphere_agrees(&((const Job05 *)job)->projection[i],
                         mistake->is_textbook ? ORACLE_TEXTBOOK : ORACLE_PROJECTION, mistake,
                         ((const float *)answers)[i]);
}

// What became of a range's hits.
typedef struct HitCounts {
    int n_right;  // found where they are,
    int n_lost;   // not found at all,
    int n_off;    // found where nothing of the sphere is
} HitCounts;

static HitCounts count_sphere_hits(const SphereRayJob *jobs, OracleForm form, Range range,
                                   const float *answers)
{
    HitCounts counts = {0};
    for (int i = 0; i < range.n; i++) {
        const SphereRayJob *job = &jobs[range_at(range, i)];
        const float found = answers[range_at(range, i)];
        const OracleRoot root = expected_hit(job, form, &right);
        const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
        const OracleChord chord = oracle3d_chord(job->sphere, &ray, form);
        counts.n_right += !is_miss(found) && is_right_root(&root, found);
        counts.n_lost += is_miss(found) && root.is_certain;
        counts.n_off += !is_miss(found) &&
                        fabs(found - chord.middle) > 1.25 * fabs(job->sphere.radius) + chord.error;
    }
    return counts;
}

// Whoever only misses hits finds others. The textbook's form is so far off with small and far
// spheres that any answer could be its: it loses hits, and finds others beside the sphere.
static int sphere_shows(HitCounts counts, int mistake)
{
    return root_mistakes[mistake].is_missed     ? counts.n_right > 0
           : root_mistakes[mistake].is_textbook ? counts.n_lost > 0 && counts.n_off > 0
                                                : 1;
}

static int textbook_shows(const void *job, Range range, const void *answers, int mistake)
{
    return sphere_shows(
        count_sphere_hits(((const Job05 *)job)->textbook, ORACLE_TEXTBOOK, range, answers),
        mistake);
}

static int projection_shows(const void *job, Range range, const void *answers, int mistake)
{
    return sphere_shows(
        count_sphere_hits(((const Job05 *)job)->projection, ORACLE_PROJECTION, range, answers),
        mistake);
}

static char *describe_sphere(const SphereRayJob *job, OracleForm form, float found)
{
    return message_new("sphere at %s, ray from %s along %s, t_min %g: found %.9g, expected %.9g",
                       words_sphere(job->sphere).text, words_vec3(job->origin, 6).text,
                       words_vec3(job->direction, 7).text, job->t_min, found,
                       expected_hit(job, form, &right).t);
}

static char *describe_textbook(const void *job, int i, const void *answers)
{
    return describe_sphere(&((const Job05 *)job)->textbook[i], ORACLE_TEXTBOOK,
                           ((const float *)answers)[i]);
}

static char *describe_projection(const void *job, int i, const void *answers)
{
    return describe_sphere(&((const Job05 *)job)->projection[i], ORACLE_PROJECTION,
                           ((const float *)answers)[i]);
}

const Function textbook_05 = {"textbook",
                              2 * N_SPHERES,
                              sizeof(float),
                              .describe = describe_textbook,
                              .agrees = textbook_agrees,
                              .shows = textbook_shows,
                              .counted = "inputs",
                              MISTAKES(root_mistakes)};
const Function projection_05 = {"projection",
                                3 * N_SPHERES,
                                sizeof(float),
                                .describe = describe_projection,
                                .agrees = projection_agrees,
                                .shows = projection_shows,
                                .counted = "inputs",
                                MISTAKES(root_mistakes)};
