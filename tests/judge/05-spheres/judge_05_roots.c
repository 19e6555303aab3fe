// Lab 05: nearest_root, intersect_textbook and intersect_sphere on their inputs. See judge_05.h;
// judge_05_shading.c is the sibling.
#include "judge_05.h"

#include "judge_05_mistakes.h"
#include "message.h"
#include "oracle3d.h"
#include "words.h"

#include <float.h>
#include <math.h>

static const OracleRules3D right = {0};

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
static int touches(RootJob job, const RootMistake *mistake)
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
static int is_mistaken_root(RootJob job, const RootMistake *mistake, float found)
{
    static const Misses misses = {INFINITY, INFINITY};
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
    const RootMistake *mistake = &root_mistakes_05[number];
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
    return !root_mistakes_05[mistake].is_missed || n_hits > 0;
}

static char *describe_root(const void *pointer, int i, const void *answers)
{
    const RootJob job = ((const Job05 *)pointer)->roots[i];
    const double expected = job.disc != 0                        ? expected_root(job, &right).t
                            : touches(job, &root_mistakes_05[0]) ? (double)job.b
                                                                 : (double)INFINITY;
    return message_new("b %g, disc %g, radius %g, t_min %.9g: found %.9g, expected %.9g", job.b,
                       job.disc, job.radius, job.t_min, ((const float *)answers)[i], expected);
}

const Function nearest_root_05 = {"roots", 3 * N_ROOTS, sizeof(float),
                                  COMPARED(root_agrees, describe_root, root_mistakes_05),
                                  .shows = root_shows};

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

// What a mistake hands to nearest_root, and how far float may be off with its disc.
typedef struct Mistaken {
    Quadratic in;
    double doubt;
} Mistaken;

static Mistaken mistaken_of(const SphereRayJob *job, MistakenQuadratic *mistaken)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    const OracleVector centre = {job->sphere.x, job->sphere.y, job->sphere.z};
    const OracleVector c = vector_minus(centre, ray.origin);
    const double b = vector_dot(c, ray.direction), c2 = vector_dot(c, c);
    return (Mistaken){mistaken(b, c2, job->sphere.radius), MISTAKEN_DISC_ERROR * (b * b + c2)};
}

// Does an answer come of b and disc with a mistake?
static int is_mistaken_hit(const SphereRayJob *job, MistakenQuadratic *mistaken, float found)
{
    const Mistaken what = mistaken_of(job, mistaken);
    const Quadratic in = what.in;
    const double half = sqrt(fmax(in.disc, 0)), t_near = in.b - half, t_far = in.b + half;
    if (fabs(in.disc) <= what.doubt) {
        // Float may find it negative or not: the roots are near b, or there are none.
        return is_miss(found) || fabs(found - in.b) <= 2 * sqrt(what.doubt);
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

static int sphere_agrees(const SphereRayJob *job, OracleForm form, const RootMistake *mistake,
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
    if (touches_exactly_05(job) && (mistake == root_mistakes_05 || mistake->touching_missed)) {
        return mistake->touching_missed ? is_miss(found) : found == job->sphere.z - job->origin.z;
    }
    const OracleRoot root = expected_hit(job, form, &mistake->rules);
    return (mistake->is_missed && is_miss(found)) || is_right_root(&root, found);
}

static int textbook_agrees(const void *job, int i, const void *answers, int mistake)
{
    return sphere_agrees(&((const Job05 *)job)->textbook[i], ORACLE_TEXTBOOK,
                         &root_mistakes_05[mistake], ((const float *)answers)[i]);
}

static int projection_agrees(const void *job, int i, const void *answers, int number)
{
    const RootMistake *mistake = &root_mistakes_05[number];
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

// Is a mistaken quadratic certain, whichever way float rounds, of most inputs?
static int is_decided(const SphereRayJob *jobs, Range range, MistakenQuadratic *mistaken)
{
    int n_decided = 0;
    for (int i = 0; i < range.n; i++) {
        const Mistaken what = mistaken_of(&jobs[range_at(range, i)], mistaken);
        n_decided += fabs(what.in.disc) > what.doubt;
    }
    return 2 * n_decided > range.n;
}

// Whoever only misses hits finds others. The textbook's form is so far off with small and far
// spheres that any answer could be its: it loses hits, and finds others beside the sphere.
static int sphere_shows(const SphereRayJob *jobs, OracleForm form, Range range,
                        const float *answers, const RootMistake *mistake)
{
    if (mistake->quadratic != NULL) {
        return is_decided(jobs, range, mistake->quadratic);
    }
    if (!mistake->is_missed && !mistake->is_textbook) {
        return 1;
    }
    const HitCounts counts = count_sphere_hits(jobs, form, range, answers);
    return mistake->is_missed ? counts.n_right > 0 : counts.n_lost > 0 && counts.n_off > 0;
}

static int textbook_shows(const void *job, Range range, const void *answers, int mistake)
{
    return sphere_shows(((const Job05 *)job)->textbook, ORACLE_TEXTBOOK, range, answers,
                        &root_mistakes_05[mistake]);
}

static int projection_shows(const void *job, Range range, const void *answers, int mistake)
{
    return sphere_shows(((const Job05 *)job)->projection, ORACLE_PROJECTION, range, answers,
                        &root_mistakes_05[mistake]);
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

const Function textbook_05 = {"textbook", 2 * N_SPHERES, sizeof(float),
                              COMPARED(textbook_agrees, describe_textbook, root_mistakes_05),
                              .shows = textbook_shows};
const Function projection_05 = {"projection", 3 * N_SPHERES, sizeof(float),
                                COMPARED(projection_agrees, describe_projection, root_mistakes_05),
                                .shows = projection_shows};
