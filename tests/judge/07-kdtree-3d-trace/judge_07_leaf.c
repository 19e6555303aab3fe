// Judging the answers of lab 07's search_leaf by the double-precision oracle.
#include "judge_07.h"
#include "message.h"

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
typedef struct Mistake {
    const char *says;
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
} Mistake;

#define ASKS_POSITION "; the position in sphere_ids was taken for the id of the sphere to ask"
#define FARTHER_WINS "; that is as if a hit had to be farther than the one so far: t > hit->t"

static const Mistake mistakes[] = {
    {"; that is a position in sphere_ids, not what stands there", .is_position = 1},
    {"; hit->sphere is not set", .keeps_sphere = 1},
    // Each sphere that is nearer than the hit so far is then taken, up to the last.
    {"; hit->t is not set", .keeps_distance = 1, .rules = {.last_wins = 1}},
    {"; the hit so far was nearer: it stays", .forgets_hit = 1},
    {"; the last sphere of the leaf is missing", .rules = {.skip_last = 1}},
    {"; the first sphere of the leaf is missing", .rules = {.skip_first = 1}},
    {"; one sphere too many is asked, the one before the leaf's or the one behind them",
     .rules = {.one_sphere_more = 1}},
    {"; of two equally far spheres the later one won", .rules = {.later_wins_ties = 1}},
    {"; the hit so far stayed, where a sphere with a lower id is just as far away",
     .first_stays = 1},
    {"; that is as if the first sphere that is hit won, however far", .rules = {.first_wins = 1}},
    {"; that is as if the last sphere that is hit won, however far", .rules = {.last_wins = 1}},
    {"; that is as if the farthest sphere won", .rules = {.farthest_wins = 1}},
    {FARTHER_WINS, .comparison = FARTHER},
    {FARTHER_WINS, .comparison = FARTHER, .lower_wins = 1},
    {FARTHER_WINS, .comparison = FARTHER_HIT},
    {FARTHER_WINS, .comparison = FARTHER_HIT, .lower_wins = 1},
    {FARTHER_WINS, .comparison = FARTHER_OR_ANY},
    {ASKS_POSITION, .comparison = NEARER, .asks_position = 1},
    {ASKS_POSITION, .comparison = NEARER, .asks_position = 1, .lower_wins = 1},
    {ASKS_POSITION, .comparison = NEARER, .asks_position = 1, .keeps_position = 1},
    {ASKS_POSITION, .comparison = NEARER, .asks_position = 1, .keeps_position = 1, .lower_wins = 1},
    {"; hit->sphere is a position in sphere_ids, not what stands there", .comparison = NEARER,
     .keeps_position = 1, .lower_wins = 1},
    {"; the first ids of the tree were asked: the leaf's begin at node.first", .comparison = NEARER,
     .from_start = 1},
    {"; the first ids of the tree were asked: the leaf's begin at node.first", .comparison = NEARER,
     .from_start = 1, .lower_wins = 1},
};
enum { N_MISTAKES = sizeof mistakes / sizeof *mistakes };

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
static int wins_tie(u32 id, u32 id_so_far, const Mistake *mistake)
{
    if (mistake != NULL && (mistake->first_stays || mistake->rules.later_wins_ties)) {
        return mistake->rules.later_wins_ties;
    }
    return id < id_so_far;
}

// Does a distance take the place of the one so far, in a mistaken loop?
static int takes(const Mistake *mistake, double t, u32 id, const LeafHit *so_far)
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
static LeafHit looped_hit(const Inputs07 *inputs, int i, const Mistake *mistake)
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

static LeafHit expected_hit(const Inputs07 *inputs, int i, const Mistake *mistake)
{
    if (mistake != NULL && mistake->comparison != 0) {
        return looped_hit(inputs, i, mistake);
    }
    const SearchJob *job = &inputs->leaves[i];
    const u32 *ids = inputs->leaf_ids + job->node.first;
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, 0);
    const OracleRules3D rules = mistake ? mistake->rules : right;
    Sphere spheres[LEAF_MAX_SPHERES + 1];
    u32 positions[LEAF_MAX_SPHERES + 1] = {0}, n_spheres = 0;
    for (u32 at = 0; at <= job->node.n_spheres; at++) {
        const Sphere sphere = inputs->leaf_spheres[ids[at]];
        const int is_guard = at == job->node.n_spheres;
        // Who takes the first or the last takes it of those that are nearer than the hit so far.
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
    // Where the hit so far is as far as the leaf's, rounding decides, but where nothing is rounded.
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

// The mistake that explains the answers of a range; "" when none does.
static const char *explain(const Inputs07 *inputs, int first, const SearchAnswer *found)
{
    for (int m = 0; m < N_MISTAKES; m++) {
        int i = first, n_changed = 0;
        for (; i < first + N_LEAF_INPUTS; i++) {
            const LeafHit hit = expected_hit(inputs, i, &mistakes[m]);
            const LeafHit right_hit = expected_hit(inputs, i, NULL);
            if (!right_hit.is_ambiguous && !agrees(&hit, found[i])) {
                break;
            }
            n_changed +=
                found[i].t != inputs->leaves[i].t || found[i].sphere != inputs->leaves[i].sphere;
        }
        // That no hit changes has many reasons.
        if (i == first + N_LEAF_INPUTS && n_changed > 0) {
            return mistakes[m].says;
        }
    }
    return "";
}

// "nothing", or "sphere 3 at t = 4.5".
static void describe_hit(char *text, size_t n_bytes, u32 sphere, double t)
{
    if (sphere == ORACLE_NO_SPHERE && t == INFINITY) {
        snprintf(text, n_bytes, "nothing");
    } else if (sphere == ORACLE_NO_SPHERE) {
        snprintf(text, n_bytes, "no sphere at t = %.9g", t);
    } else {
        snprintf(text, n_bytes, "sphere %u at t = %.9g", sphere, t);
    }
}

static const SearchAnswer *answers_of(const Sections *answers)
{
    return sections_find(answers, "leaves", N_LEAVES * sizeof(SearchAnswer));
}

Verdict inputs_07_judge_leaves(const Inputs07 *inputs, int range, const Sections *answers)
{
    const SearchAnswer *found = answers_of(answers);
    if (found == NULL) {
        return verdict_missing;
    }
    const int start = range * N_LEAF_INPUTS;
    int n_wrong = 0, first = 0;
    for (int i = start + N_LEAF_INPUTS - 1; i >= start; i--) {
        const LeafHit expected = expected_hit(inputs, i, NULL);
        // The first range is about distances, the second about whose they are.
        const int is_right =
            range == 0 ? is_right_t(&expected, found[i].t) : found[i].sphere == expected.sphere;
        if (!expected.is_ambiguous && !is_right) {
            n_wrong++;
            first = i;
        }
    }
    if (n_wrong == 0) {
        return verdict_of(NULL);
    }
    const SearchJob *job = &inputs->leaves[first];
    const LeafHit expected = expected_hit(inputs, first, NULL);
    char before[64], own[64], wanted[64];
    describe_hit(before, sizeof before, job->sphere, job->t);
    describe_hit(own, sizeof own, found[first].sphere, found[first].t);
    describe_hit(wanted, sizeof wanted, expected.sphere, expected.t);
    return verdict_of(
        message_new("a leaf of %u sphere%s, its ids from %u on, ray from (%g, %g, %g) along (%.7g, "
                    "%.7g, %.7g), "
                    "hit so far: %s: found %s, expected %s (%d of %d inputs are wrong)%s",
                    job->node.n_spheres, job->node.n_spheres == 1 ? "" : "s", job->node.first,
                    (double)job->origin.x, (double)job->origin.y, (double)job->origin.z,
                    (double)job->direction.x, (double)job->direction.y, (double)job->direction.z,
                    before, own, wanted, n_wrong, N_LEAF_INPUTS, explain(inputs, start, found)));
}

Verdict inputs_07_judge_leaf_tests(const Inputs07 *inputs, const Sections *answers)
{
    const SearchAnswer *found = answers_of(answers);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_LEAVES; i++) {
        const u32 n_spheres = inputs->leaves[i].node.n_spheres, n_tests = found[i].n_tests;
        if (n_tests == UNTOUCHED) {
            return verdict_of(message_new("the work could not be counted; call intersect_sphere in "
                                          "search_leaf itself"));
        }
        if (n_tests != n_spheres) {
            return verdict_of(message_new("a leaf of %u sphere%s: intersect_sphere was called %u "
                                          "times, expected %u, once for each sphere of the leaf",
                                          n_spheres, n_spheres == 1 ? "" : "s", n_tests,
                                          n_spheres));
        }
    }
    return verdict_of(NULL);
}
