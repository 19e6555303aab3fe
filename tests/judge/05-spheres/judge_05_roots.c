// Lab 05: nearest_root, intersect_textbook and intersect_sphere on their inputs. See judge_05.h;
// judge_05_shading.c is the sibling.
#include "judge_05.h"

#include "message.h"
#include "oracle3d.h"
#include "oracle3d_rounding.h"
#include "words.h"

#include <float.h>

// ---- Inputs -------------------------------------------------------------------------------------

// A ray's line and a sphere: what each of the three functions is about.
typedef struct Line {
    double b, disc, radius, t_min;
    double c2;             // the centre's distance from the eye, squared; nearest_root gets none
    double t_near, t_far;  // where the line enters the sphere, and where it leaves
    double error;          // how far float may be off such a root
    int is_miss;           // it does not meet the sphere
    int is_doubtful;       // float may find that it does or does not, near b
    int is_touch;          // it touches the sphere, and all is exact in float, too
    int is_afar;           // the eye is far from the scene's origin
} Line;

// What nearest_root gets is exact: float rounds the root, by 3 ulp (OpenCL 1.2, 7.4), and a sum.
static Line line_of_root(RootJob job)
{
    const double half = sqrt(fmax(job.disc, 0));
    return (Line){.b = job.b,
                  .disc = job.disc,
                  .radius = job.radius,
                  .t_min = job.t_min,
                  .t_near = job.b - half,
                  .t_far = job.b + half,
                  .error = half > 0 ? 8 * ROUNDING * (fabs((double)job.b) + half) : 0,
                  .is_miss = job.disc < 0,
                  .is_touch = job.disc == 0};
}

int touches_exactly_05(const SphereRayJob *job)
{
    const double x = (double)job->sphere.x - job->origin.x;
    const double y = (double)job->sphere.y - job->origin.y;
    return job->direction.x == 0 && job->direction.y == 0 &&
           x * x + y * y == (double)job->sphere.radius * job->sphere.radius;
}

static OracleRay ray_of(const SphereRayJob *job)
{
    return oracle3d_given_ray(job->origin, job->direction, job->t_min);
}

static Line line_of_sphere(const SphereRayJob *job, OracleForm form)
{
    const OracleRay ray = ray_of(job);
    const OracleVector c = vector_minus(centre_of(job->sphere), ray.origin);
    const double r = job->sphere.radius;
    const OracleChord chord = oracle3d_chord(job->sphere, &ray, form);
    Line line = {.b = chord.middle,
                 .radius = r,
                 .t_min = job->t_min,
                 .c2 = vector_dot(c, c),
                 .is_miss = !chord.is_possible,
                 .is_touch = touches_exactly_05(job),
                 .is_afar = fabsf(job->origin.x) > 1000};
    const double half = line.is_touch || isnan(chord.half) ? 0 : chord.half;
    line.disc = line.b * line.b - (line.c2 - r * r);
    line.t_near = line.b - half, line.t_far = line.b + half;
    line.is_doubtful = !line.is_miss && !line.is_touch && !chord.is_certain;
    if (!line.is_miss && !line.is_touch) {
        line.error = fmax(chord.longest - half, half - chord.shortest) + chord.error +
                     ROUNDING * (fabs(line.b) + chord.longest);
    }
    return line;
}

// The first ranges are harmless for either form, and a mistake may be made in either.
static Line line_at(const Inputs05 *inputs, int i)
{
    return inputs->roots != NULL
               ? line_of_root(inputs->roots[i])
               : line_of_sphere(&inputs->spheres[i],
                                i < 2 * N_SPHERES ? ORACLE_TEXTBOOK : ORACLE_PROJECTION);
}

#define GIVEN                                                                                      \
    const Inputs05 *inputs = job;                                                                  \
    const Line in = line_at(inputs, i);                                                            \
    const float found = ((const float *)answers)[i];                                               \
    (void)inputs
#define IS_FOUND(t) is_found(in, t, found)

static int is_found(Line in, double t, float found)
{
    return found == t || (isnan(t) && isnan(found)) ||
           (in.is_doubtful ? found == INFINITY || fabs(found - in.b) <= in.error + in.t_far - in.b
                           : fabs(found - t) <= in.error);
}

// ---- Right --------------------------------------------------------------------------------------

// Which root is the hit: where the ray enters, if that counts, else where it leaves, if that does.
static double hit(Line in, int enters, int leaves)
{
    return in.is_miss ? INFINITY : enters ? in.t_near : leaves ? in.t_far : INFINITY;
}

static int enters(Line in, double limit)
{
    return in.radius > 0 && in.t_near > limit;
}

static int leaves(Line in, double limit)
{
    return in.t_far > limit;
}

static double right_hit(Line in)
{
    return hit(in, enters(in, in.t_min), leaves(in, in.t_min));
}

RIGHT(is_right_root, IS_FOUND(right_hit(in)))

static int is_right_hit(const SphereRayJob *job, OracleForm form, float found)
{
    static const OracleRules3D right = {0};
    const OracleRay ray = ray_of(job);
    const OracleRoot root = oracle3d_root(job->sphere, &ray, form, &right);
    return touches_exactly_05(job) ? found == job->sphere.z - job->origin.z
           : found == INFINITY     ? !root.is_certain
                               : root.is_possible && found >= root.t_low && found <= root.t_high;
}

RIGHT(is_right_sphere, is_right_hit(&inputs->spheres[i], inputs->form, found))

// ---- Mistakes -----------------------------------------------------------------------------------

// With another half of the chord.
static int has_half(Line in, double half, float found)
{
    in.t_near = in.b - half, in.t_far = in.b + half;
    in.error = 8 * ROUNDING * (fabs(in.b) + half);
    return IS_FOUND(right_hit(in));
}

static int has_root_of_size(Line in, float found)
{
    in.is_miss = 0;
    return has_half(in, sqrt(fabs(in.disc)), found);
}

// Epsilons, whose size is not known: the largest number that was taken for nothing says it.
#define LARGEST_EPSILON 0.1

typedef struct Epsilons {
    double disc;         // that was taken for negative, 0 for none
    double entry, exit;  // how far beyond t_min an entry was left out, or an exit; 0 for none
} Epsilons;

static Epsilons epsilons_of(const void *job, const void *answers)
{
    Epsilons epsilons = {0};
    for (int i = 0; i < 3 * N_ROOTS; i++) {
        GIVEN;
        if (IS_FOUND(right_hit(in))) {
            continue;
        }
        if (enters(in, in.t_min)) {
            epsilons.entry = fmax(epsilons.entry, in.t_near - in.t_min);
        }
        if (leaves(in, in.t_min) && found == INFINITY) {
            epsilons.exit = fmax(epsilons.exit, in.t_far - in.t_min);
        }
        epsilons.disc = fmax(epsilons.disc, in.is_miss ? INFINITY : in.disc);
    }
    return epsilons;
}

// With an epsilon for the disc; for t_min, of the entry alone or of both. What is far from all of
// them is as it should be.
static int is_by_disc(Line in, float found, const void *job, const void *answers)
{
    if (in.is_miss || in.disc > LARGEST_EPSILON) {
        return IS_FOUND(right_hit(in));
    }
    const double epsilon = epsilons_of(job, answers).disc;
    return epsilon > 0 && epsilon <= LARGEST_EPSILON &&
           IS_FOUND(in.disc <= epsilon ? INFINITY : right_hit(in));
}

static int is_by_t_min(Line in, float found, const void *job, const void *answers, int of_both)
{
    if (fabs(in.t_near - in.t_min) > LARGEST_EPSILON &&
        fabs(in.t_far - in.t_min) > LARGEST_EPSILON) {
        return IS_FOUND(right_hit(in));
    }
    const Epsilons epsilons = epsilons_of(job, answers);
    const double epsilon = of_both ? fmax(epsilons.entry, epsilons.exit) : epsilons.entry;
    return epsilon > 0 && epsilon <= LARGEST_EPSILON && (of_both || epsilons.exit == 0) &&
           IS_FOUND(hit(in, in.radius > 0 && in.t_near - in.t_min > epsilon,
                        in.t_far - in.t_min > (of_both ? epsilon : 0)));
}

// Does the answer come of a number that the stub of nearest_root makes of these?
static int comes_of_stub(const Inputs05 *inputs, Line in, double b, double disc, double doubt,
                         float found)
{
    const double half = sqrt(fmax(disc, 0));
    const double least = inputs->root(b, fmax(disc - doubt, 0), in.radius, in.t_min, inputs->nonce);
    const double most = inputs->root(b, fmax(disc + doubt, 0), in.radius, in.t_min, inputs->nonce);
    const double error = 1e-4 * (fabs(b) + half + fabs(in.radius) + in.t_min);
    return found == INFINITY ? disc <= doubt
                             : disc >= -doubt && found >= least - error && found <= most + error;
}

// Of what is handed to nearest_root. Small spheres far away tell nothing of it, as float may find
// the disc positive or negative: with them any answer may come of it.
static int comes_of(const Inputs05 *inputs, Line in, double b, double disc, float found)
{
    const double doubt = 0x1p-18 * (b * b + in.c2), half = sqrt(fmax(disc, 0));
    if (inputs->root != NULL) {
        return fabs(in.radius) <= 1e-3 * sqrt(in.c2) ||
               comes_of_stub(inputs, in, b, disc, doubt, found);
    }
    in.is_miss = disc < 0, in.is_doubtful = fabs(disc) <= doubt;
    in.b = b, in.t_near = b - half, in.t_far = b + half;
    in.error = in.is_doubtful ? sqrt(doubt) : 1e-4 * (fabs(b) + half);
    return fabs(in.radius) <= 1e-3 * sqrt(in.c2) || IS_FOUND(right_hit(in));
}

#define B_TURNED "b has the wrong sign: what is ahead is taken for what is behind"

// The textbook's form is so far off with small spheres far away that any answer could be its: it
// loses hits of the range, and finds others beside the sphere.
static int loses_and_misplaces(const SphereRayJob *jobs, const float *found)
{
    int n_lost = 0, n_beside = 0;
    for (int i = 0; i < N_SPHERES; i++) {
        const OracleRay ray = ray_of(&jobs[i]);
        const OracleChord chord = oracle3d_chord(jobs[i].sphere, &ray, ORACLE_PROJECTION);
        const double beside = 1.25 * fabs(jobs[i].sphere.radius) + chord.error;
        n_lost += found[i] == INFINITY && !is_right_hit(&jobs[i], ORACLE_PROJECTION, INFINITY);
        n_beside += found[i] < INFINITY && fabs(found[i] - chord.middle) > beside;
    }
    return n_lost > 0 && n_beside > 0;
}

KNOWN_LIST(known_of_both)
{
    GIVEN;
    const double right = right_hit(in);

    // Of the root.
    ANSWERS(touching_missed, in.is_touch ? INFINITY : right,
            "where disc is 0 the ray touches the sphere, and that is a hit");
    ANSWERS(farther, hit(in, 0, leaves(in, in.t_min)),
            "that is the farther root, where the ray leaves the sphere");
    ANSWERS(any_distance, hit(in, in.radius > 0, 1), "that is not beyond t_min");
    ANSWERS(negative_missed, in.radius < 0 ? INFINITY : right,
            "a sphere with a negative radius is seen from inside");
    ANSWERS(inside_missed, hit(in, enters(in, in.t_min), 0),
            "from inside the second root is the hit: b + sqrt(disc)");
    ANSWERS(sign_ignored, hit(in, in.t_near > in.t_min, leaves(in, in.t_min)),
            "a negative radius means that only the farther root counts");
    ANSWERS(negative_always, hit(in, enters(in, in.t_min), in.radius < 0 || leaves(in, in.t_min)),
            "where the radius is negative the farther root counts beyond t_min only, too");
    ANSWERS(t_min_is_0, hit(in, enters(in, 0), leaves(in, 0)),
            "t_min is the ray's, and need not be 0");
    EACH(behind_missed, fabs(in.b) <= in.error || IS_FOUND(in.b < 0 ? INFINITY : right),
         "the centre is behind the eye, which does not matter where the eye is inside");
    ONLY(missed, found == INFINITY,
         "other hits are right, and nothing but a negative disc and t_min makes a miss");
    return NO_MORE;
}

KNOWN_LIST(known_of_root)
{
    GIVEN;
    const double right = right_hit(in);

    ANSWERS(inside_missed_of_positive,
            hit(in, enters(in, in.t_min), in.radius < 0 && leaves(in, in.t_min)),
            "from inside the second root is the hit: b + sqrt(disc)");

    // Of nearest_root only.
    ANSWERS(t_min_counts, hit(in, in.radius > 0 && in.t_near >= in.t_min, in.t_far >= in.t_min),
            "t_min itself does not count");
    ANSWERS(entry_at_t_min, hit(in, in.radius > 0 && in.t_near >= in.t_min, leaves(in, in.t_min)),
            "an entry at t_min itself does not count");
    ANSWERS(exit_unasked, hit(in, enters(in, in.t_min), 1),
            "the exit counts beyond t_min only, too");
    ANSWERS(part_begins,
            in.radius > 0 && !in.is_miss && leaves(in, in.t_min) ? fmax(in.t_near, in.t_min)
                                                                 : right,
            "from inside the hit is where the ray leaves the sphere, not t_min");
    ANSWERS(largest_float, right == INFINITY ? FLT_MAX : right,
            "where nothing is hit INFINITY is to be returned, not the largest float");
    ANSWERS(root_of_negative, in.disc < 0 ? NAN : right,
            "a negative disc has no root: it is a miss, to be found before sqrt() makes NaN");
    ANSWERS(zero, right == INFINITY ? 0 : right,
            "where nothing is hit INFINITY is to be returned, not 0");

    EACH(disc_unrooted, has_half(in, in.disc, found),
         "disc is the square of half the chord: its root was forgotten");
    EACH(quarter_chord, has_half(in, sqrt(fmax(in.disc, 0)) / 2, found),
         "sqrt(disc) is half of the chord already, and needs no division by 2");
    EACH(size_of_disc, has_root_of_size(in, found),
         "a negative disc is a miss: the root of its size finds hits beside the sphere");

    EACH(
        disc_by_hair, is_by_disc(in, found, job, answers),
        "a disc that is positive by however little, or 0, is a hit: compare it with 0, no epsilon");
    EACH(beyond_by_hair, is_by_t_min(in, found, job, answers, 1),
         "a hit beyond t_min by however little counts: no epsilon");
    EACH(entry_by_hair, is_by_t_min(in, found, job, answers, 0),
         "an entry beyond t_min by however little counts: no epsilon");
    return NO_MORE;
}

KNOWN_LIST(known_of_call)
{
    GIVEN;
    const double c = in.c2 - in.radius * in.radius;
    const double less_way = in.radius - sqrt(fmax(in.c2 - in.b * in.b, 0));

    EACH(b_turned, comes_of(inputs, in, -in.b, in.disc, found), B_TURNED);
    // The same where b is in l, too, as in the projection.
    EACH(b_turned_in_l, comes_of(inputs, in, -in.b, -c - 3 * in.b * in.b, found), B_TURNED);
    EACH(both_undivided, comes_of(inputs, in, 2 * in.b, 4 * in.disc, found),
         "the formula with 2 b divides by 2 in the end: both roots are twice as far");
    EACH(disc_halved, comes_of(inputs, in, in.b, 2 * in.disc, found),
         "disc is twice as large: with 2 b for b it is divided by 4");
    EACH(four_times_c, comes_of(inputs, in, in.b, -4 * c + in.b * in.b, found),
         "with half of the equation's b the discriminant is b² - c, not b² - 4 c");
    EACH(c_turned, comes_of(inputs, in, in.b, c + in.b * in.b, found),
         "c has the wrong sign: the discriminant is b² - c");
    EACH(b_doubled, comes_of(inputs, in, 2 * in.b, 4 * in.b * in.b - c, found),
         "b is twice as large: b² - c goes with half of the equation's b");
    EACH(way_kept, comes_of(inputs, in, in.b, in.radius * in.radius - in.c2, found),
         "l is the whole way to the centre: its part along the ray is to be taken off");
    EACH(length_as_it_is,
         comes_of(inputs, in, in.b, in.radius * in.radius - sqrt(fmax(in.c2 - in.b * in.b, 0)),
                  found),
         "the length of l is not squared");
    EACH(radius_as_it_is, comes_of(inputs, in, in.b, in.radius - in.c2 + in.b * in.b, found),
         "the radius is not squared");
    EACH(radius_less_way, comes_of(inputs, in, in.b, pow(less_way, 2), found),
         "the square of r - |l| is never negative: the difference is that of squares");
    EACH(unsquared,
         comes_of(inputs, in, in.b, in.radius - sqrt(fmax(in.c2 - in.b * in.b, 0)), found),
         "neither the radius nor the length of l is squared");
    EACH(way_added, comes_of(inputs, in, in.b, -c - 3 * in.b * in.b, found),
         "l: the part along the ray was added to the way to the centre: it is taken off");
    EACH(b_unsquared, comes_of(inputs, in, in.b, in.b - c, found),
         "b is not squared: the discriminant is b² - c");
    EACH(disc_of_whole_b, comes_of(inputs, in, in.b, 4 * in.disc, found),
         "disc is four times as large: b² - 4 c goes with the whole b of the equation, and with "
         "half of it b² - c");
    EACH(disc_turned, comes_of(inputs, in, in.b, -in.disc, found), "disc has the wrong sign");
    return NO_MORE;
}

KNOWN_LIST(known_of_sphere)
{
    GIVEN;

    EACH(textbook_form,
         is_right_hit(&inputs->spheres[i], ORACLE_TEXTBOOK, found) &&
             (i % N_SPHERES > 0 ||
              loses_and_misplaces(&inputs->spheres[i], (const float *)answers + i)),
         "the digits are lost: the textbook's form, or one like it, which squares before it "
         "subtracts");
    EACH(lost_afar, in.is_afar || is_right_hit(&inputs->spheres[i], inputs->form, found),
         "near the scene's origin hits are right, far from it their digits are lost: subtract the "
         "eye first, and go on with the difference only");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe_root(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("b %g, disc %g, radius %g, t_min %.9g: found %.9g, expected %.9g", in.b,
                       in.disc, in.radius, in.t_min, found, right_hit(in));
}

static char *describe_sphere(const void *job, int i, const void *answers)
{
    GIVEN;
    const SphereRayJob *sphere = &inputs->spheres[i];
    return message_new("sphere at %s, ray from %s along %s, t_min %g: found %.9g, expected %.9g",
                       words_sphere(sphere->sphere).text, words_vec3(sphere->origin, 6).text,
                       words_vec3(sphere->direction, 7).text, in.t_min, found,
                       in.disc < 0 && !in.is_touch ? (double)INFINITY : right_hit(in));
}

const Function nearest_root_05 = {
    "roots",
    3 * N_ROOTS,
    sizeof(float),
    KNOWING(is_right_root, describe_root, known_of_both, known_of_root),
    .inputs = offsetof(Job05, of_root),
    .is_known_by_range = 1};
const Function textbook_05 = {
    "textbook",
    2 * N_SPHERES,
    sizeof(float),
    KNOWING(is_right_sphere, describe_sphere, known_of_both, known_of_call, known_of_sphere),
    .inputs = offsetof(Job05, of_textbook),
    .is_known_by_range = 1};
const Function projection_05 = {
    "projection",
    3 * N_SPHERES,
    sizeof(float),
    KNOWING(is_right_sphere, describe_sphere, known_of_both, known_of_call, known_of_sphere),
    .inputs = offsetof(Job05, of_sphere),
    .is_known_by_range = 1};
const Function textbook_alone_05 = {"textbook",
                                    2 * N_SPHERES,
                                    sizeof(float),
                                    KNOWING(is_right_sphere, describe_sphere, known_of_call),
                                    .inputs = offsetof(Job05, of_textbook),
                                    .is_known_by_range = 1};
const Function projection_alone_05 = {"projection",
                                      3 * N_SPHERES,
                                      sizeof(float),
                                      KNOWING(is_right_sphere, describe_sphere, known_of_call),
                                      .inputs = offsetof(Job05, of_sphere),
                                      .is_known_by_range = 1};
