// Judging the answers of lab 07's search_leaf by the double-precision oracle.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

static const OracleRules3D right = {0};

// How a mistaken loop over the leaf decides whether a distance takes the place of the one so far.
typedef enum Comparison {
    NEARER = 1,      // as it should, but of two equal distances the hit so far stays
    FARTHER,         // t > hit->t: misses, which are infinitely far, win
    FARTHER_HIT,     // the same, but misses are passed over: no hit so far stays for ever
    FARTHER_OR_ANY,  // the same, but in place of no hit so far comes any
} Comparison;

// A known mistake: rules of the oracle's, or one about the hit so far, or a loop that is played
// again with what it mistakes for what.
typedef struct LeafMistake {
    Cause cause;
    OracleRules3D rules;
    int forgets_hit;        // the hit so far is replaced whatever it is
    int is_position;        // the sphere is a position in sphere_ids
    int keeps_sphere;       // the sphere is never set
    int keeps_distance;     // nor is t
    int first_stays;        // of equally far ones the hit so far
    Comparison comparison;  // of a loop; 0 where none is played, as for all above
    int lower_wins;         // of equal distances that of the lower number, as it should
    int asks_position;      // the loop asks the sphere whose id is the position in sphere_ids,
    int keeps_position;     // and keeps the position
    int from_start;         // it runs over the first ids of the tree
} LeafMistake;

#define ASKS_POSITION "the position in sphere_ids was taken for the id of the sphere to ask"
#define FARTHER_WINS "that is as if a hit had to be farther than the one so far: t > hit->t"

static const LeafMistake mistakes[] = {
    {{.says = "that is a position in sphere_ids, not what stands there"}, .is_position = 1},
    {{.says = "hit->sphere is not set"}, .keeps_sphere = 1},
    // Each sphere that is nearer than the hit so far is then taken, up to the last.
    {{.says = "hit->t is not set"}, .keeps_distance = 1, .rules = {.last_wins = 1}},
    {{.says = "the hit so far was nearer: it stays"}, .forgets_hit = 1},
    {{"the last sphere of the leaf is missing", MISTAKE_MISSING_IN_CELL},
     .rules = {.skip_last = 1}},
    {{"the first sphere of the leaf is missing", MISTAKE_MISSING_IN_CELL},
     .rules = {.skip_first = 1}},
    {{.says = "one sphere too many is asked, the one before the leaf's or the one behind them"},
     .rules = {.one_sphere_more = 1}},
    {{"of two equally far spheres the later one won", MISTAKE_LATER_OF_EQUALS},
     .rules = {.later_wins_ties = 1}},
    {{.says = "the hit so far stayed, where a sphere with a lower id is just as far away"},
     .first_stays = 1},
    {{.says = "that is as if the first sphere that is hit won, however far"},
     .rules = {.first_wins = 1}},
    {{.says = "that is as if the last sphere that is hit won, however far"},
     .rules = {.last_wins = 1}},
    {{.says = "that is as if the farthest sphere won"}, .rules = {.farthest_wins = 1}},
    {{.says = FARTHER_WINS}, .comparison = FARTHER},
    {{.says = FARTHER_WINS}, .comparison = FARTHER, .lower_wins = 1},
    {{.says = FARTHER_WINS}, .comparison = FARTHER_HIT},
    {{.says = FARTHER_WINS}, .comparison = FARTHER_HIT, .lower_wins = 1},
    {{.says = FARTHER_WINS}, .comparison = FARTHER_OR_ANY},
    {{.says = ASKS_POSITION}, .comparison = NEARER, .asks_position = 1},
    {{.says = ASKS_POSITION}, .comparison = NEARER, .asks_position = 1, .lower_wins = 1},
    {{.says = ASKS_POSITION}, .comparison = NEARER, .asks_position = 1, .keeps_position = 1},
    {{.says = ASKS_POSITION},
     .comparison = NEARER,
     .asks_position = 1,
     .keeps_position = 1,
     .lower_wins = 1},
    {{.says = "hit->sphere is a position in sphere_ids, not what stands there"},
     .comparison = NEARER,
     .keeps_position = 1,
     .lower_wins = 1},
    {{.says = "the first ids of the tree were asked: the leaf's begin at node.first"},
     .comparison = NEARER,
     .from_start = 1},
    {{.says = "the first ids of the tree were asked: the leaf's begin at node.first"},
     .comparison = NEARER,
     .from_start = 1,
     .lower_wins = 1},
};

// What may come out.
typedef struct LeafHit {
    u32 sphere;
    double t, t_tolerance;
    int is_ambiguous;
} LeafHit;

static int is_along_axis(Vec3 v)
{
    return (v.x == 0) + (v.y == 0) + (v.z == 0) == 2;
}

// Does the leaf's sphere take the place of the hit so far, just as far away?
static int wins_tie(u32 id, u32 id_so_far, const LeafMistake *mistake)
{
    if (mistake != NULL && (mistake->first_stays || mistake->rules.later_wins_ties)) {
        return mistake->rules.later_wins_ties;
    }
    return id < id_so_far;
}

// Does a distance take the place of the one so far, in a mistaken loop?
static int takes(const LeafMistake *mistake, double t, u32 id, const LeafHit *so_far)
{
    if (t == so_far->t && t < INFINITY) {
        return mistake->lower_wins && id < so_far->sphere;
    }
    switch (mistake->comparison) {
    case FARTHER:
        return t > so_far->t;
    case FARTHER_HIT:
        return t > so_far->t && t < INFINITY;
    case FARTHER_OR_ANY:
        return t < INFINITY && (t > so_far->t || so_far->t == INFINITY);
    default:
        return t < so_far->t;
    }
}

// What a mistaken loop over the leaf's spheres finds.
static LeafHit looped_hit(const Inputs07 *inputs, int i, const LeafMistake *mistake)
{
    const SearchJob *job = &inputs->leaves[i];
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, 0);
    const u32 first = mistake->from_start ? 0 : job->node.first;
    LeafHit result = {job->sphere, job->t, 0, 0};
    for (u32 at = first; at < first + job->node.n_spheres; at++) {
        const u32 id = inputs->leaf_ids[at];
        const Sphere sphere = inputs->leaf_spheres[mistake->asks_position ? at : id];
        const OracleRoot root = oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &right);
        result.is_ambiguous |= root.is_possible != root.is_certain;
        const u32 compared = mistake->keeps_position && mistake->asks_position ? at : id;
        if (takes(mistake, root.t, compared, &result)) {
            result.t = root.t;
            result.t_tolerance = isinf(root.t) ? 0 : root.t_high - root.t_low;
            result.sphere = mistake->keeps_position ? at : id;
        }
    }
    return result;
}

// Does the ray go along an axis and through the middle of each of the leaf's spheres? Then float
// rounds nothing but the root of the squared radius, by 3 ulp (OpenCL 1.2, 7.4), and the distance.
static int is_through_middles(const Inputs07 *inputs, const SearchJob *job)
{
    const Vec3 d = job->direction;
    int is_through = is_along_axis(d);
    for (u32 k = 0; is_through && k < job->node.n_spheres; k++) {
        const Sphere *sphere = &inputs->leaf_spheres[inputs->leaf_ids[job->node.first + k]];
        is_through = (d.x != 0 || sphere->x == job->origin.x) &&
                     (d.y != 0 || sphere->y == job->origin.y) &&
                     (d.z != 0 || sphere->z == job->origin.z);
    }
    return is_through;
}

// What a right loop finds there: the nearer one also of two that are one step of float apart.
static LeafHit hit_through_middles(const Inputs07 *inputs, int i)
{
    static const LeafMistake none = {.comparison = NEARER, .lower_wins = 1};
    LeafHit hit = looped_hit(inputs, i, &none);
    if (hit.sphere != inputs->leaves[i].sphere) {
        hit.t_tolerance = 8 * 0x1p-24 * fabs((double)inputs->leaf_spheres[hit.sphere].radius);
    }
    return hit;
}

static LeafHit expected_hit(const Inputs07 *inputs, int i, const LeafMistake *mistake)
{
    if (mistake != NULL && mistake->comparison != 0) {
        return looped_hit(inputs, i, mistake);
    }
    const SearchJob *job = &inputs->leaves[i];
    if (mistake == NULL && is_through_middles(inputs, job)) {
        return hit_through_middles(inputs, i);
    }
    const u32 *ids = inputs->leaf_ids + job->node.first;
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, 0);
    const OracleRules3D rules = mistake ? mistake->rules : right;
    Sphere spheres[N_LONG_LEAF + 1];
    u32 positions[N_LONG_LEAF + 1] = {0}, n_spheres = 0;
    for (u32 at = 0; at <= job->node.n_spheres; at++) {
        const Sphere sphere = inputs->leaf_spheres[ids[at]];
        const int is_guard = at == job->node.n_spheres;
        // These two mistakes are about the spheres that are nearer than the hit so far.
        if ((rules.first_wins || rules.last_wins) && !is_guard &&
            oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &right).t >= job->t) {
            continue;
        }
        positions[n_spheres] = at;
        spheres[n_spheres] = sphere;
        n_spheres += !is_guard;
    }
    const OracleHit hit = oracle3d_nearest(spheres, n_spheres, &ray, &rules);
    LeafHit result = {job->sphere, job->t, 0, hit.is_ambiguous};
    const double gap = hit.sphere == ORACLE_NO_SPHERE ? INFINITY : hit.t - (double)job->t;
    // If the hit so far is as far away as the leaf's, rounding decides. Along an axis nothing is
    // rounded.
    const int is_tie = gap == 0 && is_along_axis(job->direction);
    result.is_ambiguous |= fabs(gap) <= hit.t_tolerance && !is_tie;
    const int is_position = mistake != NULL && mistake->is_position;
    const u32 found_at = hit.sphere == ORACLE_NO_SPHERE ? 0 : positions[hit.sphere];
    const u32 id = is_position ? job->node.first + found_at : ids[found_at];
    const int takes = gap < 0 || (mistake && mistake->forgets_hit && gap < INFINITY) ||
                      (is_tie && wins_tie(id, job->sphere, mistake));
    if (takes) {
        result.t = mistake && mistake->keeps_distance ? (double)job->t : hit.t;
        result.t_tolerance = hit.t_tolerance;
        result.sphere = mistake && mistake->keeps_sphere ? job->sphere : id;
    }
    return result;
}

static int is_right_t(const LeafHit *expected, float t)
{
    return t == (float)expected->t || fabs(t - expected->t) <= expected->t_tolerance;
}

static int agrees(const LeafHit *expected, SearchAnswer found)
{
    return expected->is_ambiguous ||
           (is_right_t(expected, found.t) && found.sphere == expected->sphere);
}

// What all wrong answers of a range have to do with, when it is one thing.
static Cause explain_by_distance(const Inputs07 *inputs, Range range, const SearchAnswer *found)
{
    int n_close = 0, n_far = 0, n_hairs = 0, n_misses = 0, n_long = 0, n_wrong = 0;
    for (int k = 0; k < range.n; k++) {
        const int i = range_at(range, k);
        const LeafHit right_one = expected_hit(inputs, i, NULL);
        if (agrees(&right_one, found[i])) {
            continue;
        }
        n_wrong++;
        n_close += right_one.t < HAIR;
        n_far += right_one.t > 1e6 && right_one.t < INFINITY;
        n_hairs += found[i].sphere != right_one.sphere && found[i].t != (float)right_one.t &&
                   fabs(found[i].t - right_one.t) < HAIR;
        n_misses += right_one.sphere == ORACLE_NO_SPHERE && found[i].t == INFINITY;
        n_long += inputs->leaves[i].node.n_spheres == N_LONG_LEAF;
    }
    const char *says =
        n_misses == n_wrong  ? "a miss was taken for a hit: its t is INFINITY, as that of no hit "
                               "so far, and that is no tie"
        : n_long == n_wrong  ? "only the longest leaf is wrong: all of its spheres count, and "
                               "neither 8 bits hold how many they are nor 16 bits where they stand"
        : n_hairs == n_wrong ? "of two hits a hair apart the nearer one is the nearer: compare "
                               "without an epsilon"
        : n_close == n_wrong ? "only hits very close to the eye are wrong: they count, too, "
                               "without an epsilon"
        : n_far == n_wrong   ? "only hits that are very far away are wrong: they count, too; "
                               "the distance of what misses is INFINITY"
                             : NULL;
    return (Cause){.says = says};
}

// The mistake that explains the answers of a range, if one does. That no hit changes has many
// reasons.
static Cause explain(const void *job, Range range, const void *answers)
{
    const Inputs07 *inputs = &((const Job07 *)job)->inputs;
    const SearchAnswer *found = answers;
    const Cause by_distance = explain_by_distance(inputs, range, found);
    if (by_distance.says != NULL) {
        return by_distance;
    }
    for (int m = 0; m < COUNT(mistakes); m++) {
        int k = 0, n_changed = 0;
        for (; k < range.n; k++) {
            const int i = range_at(range, k);
            const LeafHit hit = expected_hit(inputs, i, &mistakes[m]);
            if (!expected_hit(inputs, i, NULL).is_ambiguous && !agrees(&hit, found[i])) {
                break;
            }
            n_changed +=
                found[i].t != inputs->leaves[i].t || found[i].sphere != inputs->leaves[i].sphere;
        }
        if (k == range.n && n_changed > 0) {
            return mistakes[m].cause;
        }
    }
    return (Cause){0};
}

// ---- Answers ------------------------------------------------------------------------------------

static LeafHit right_hit(const void *job, int i)
{
    return expected_hit(&((const Job07 *)job)->inputs, i, NULL);
}

static int t_agrees(const void *job, int i, const void *answers, int mistake)
{
    const LeafHit expected = right_hit(job, i);
    (void)mistake;
    return expected.is_ambiguous || is_right_t(&expected, ((const SearchAnswer *)answers)[i].t);
}

static int sphere_agrees(const void *job, int i, const void *answers, int mistake)
{
    const LeafHit expected = right_hit(job, i);
    (void)mistake;
    return expected.is_ambiguous || ((const SearchAnswer *)answers)[i].sphere == expected.sphere;
}

// "nothing", or "sphere 3 at t = 4.5".
static Words hit_words(u32 sphere, double t)
{
    return sphere != ORACLE_NO_SPHERE ? words("sphere %u at t = %.9g", sphere, t)
           : t == INFINITY            ? words("nothing")
                                      : words("no sphere at t = %.9g", t);
}

static char *describe_leaf(const void *pointer, int i, const void *answers)
{
    const SearchJob *job = &((const Job07 *)pointer)->inputs.leaves[i];
    const SearchAnswer own = ((const SearchAnswer *)answers)[i];
    const LeafHit expected = right_hit(pointer, i);
    return message_new("a leaf of %u sphere%s, its ids from %u on, ray from %s along %s, hit so "
                       "far: %s: found %s, expected %s",
                       job->node.n_spheres, plural(job->node.n_spheres), job->node.first,
                       words_vec3(job->origin, 6).text, words_vec3(job->direction, 7).text,
                       hit_words(job->sphere, job->t).text, hit_words(own.sphere, own.t).text,
                       hit_words(expected.sphere, expected.t).text);
}

const Function leaf_nearest_07 = {"leaves", N_LEAVES, sizeof(SearchAnswer),
                                  EXPLAINED(t_agrees, describe_leaf, explain)};
const Function leaf_ids_07 = {"leaves", N_LEAVES, sizeof(SearchAnswer),
                              EXPLAINED(sphere_agrees, describe_leaf, explain)};
