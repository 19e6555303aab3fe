// Judging the answers of lab 07's search_leaf by the double-precision oracle.
#include "judge_07.h"
#include "message.h"
#include "words.h"

#include <math.h>

// What may come out.
typedef struct LeafHit {
    u32 sphere;
    double t, t_tolerance;
    int is_ambiguous;
} LeafHit;

// ---- A search by the oracle ---------------------------------------------------------------------

// A way of searching. All zeros is the right one.
typedef struct Way {
    OracleRules3D rules;
    int forgets_hit;     // the hit so far is replaced whatever it is
    int is_position;     // the sphere is a position in sphere_ids
    int keeps_sphere;    // the sphere is never set
    int keeps_distance;  // nor is t
    int first_stays;     // of equally far ones the hit so far
} Way;

static int is_along_axis(Vec3 v)
{
    return (v.x == 0) + (v.y == 0) + (v.z == 0) == 2;
}

// Does the leaf's sphere take the place of the hit so far, just as far away?
static int wins_tie(u32 id, u32 id_so_far, Way way)
{
    return way.rules.later_wins_ties || (!way.first_stays && id < id_so_far);
}

static LeafHit searched(const Inputs07 *inputs, int i, Way way)
{
    static const OracleRules3D right = {0};
    const SearchJob *in = &inputs->leaves[i];
    const u32 *ids = inputs->leaf_ids + in->node.first;
    const OracleRay ray = oracle3d_given_ray(in->origin, in->direction, 0);
    Sphere spheres[N_LONG_LEAF + 1];
    u32 positions[N_LONG_LEAF + 1] = {0}, n_spheres = 0;
    for (u32 at = 0; at <= in->node.n_spheres; at++) {
        const Sphere sphere = inputs->leaf_spheres[ids[at]];
        const int is_guard = at == in->node.n_spheres;
        // Who takes the first or the last takes it of those that are nearer than the hit so far.
        if ((way.rules.first_wins || way.rules.last_wins) && !is_guard &&
            oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &right).t >= in->t) {
            continue;
        }
        positions[n_spheres] = at;
        spheres[n_spheres] = sphere;
        n_spheres += !is_guard;
    }
    const OracleHit hit = oracle3d_nearest(spheres, n_spheres, &ray, &way.rules);
    LeafHit result = {in->sphere, in->t, 0, hit.is_ambiguous};
    const double gap = hit.sphere == ORACLE_NO_SPHERE ? INFINITY : hit.t - (double)in->t;
    // Where the hit so far is as far as the leaf's, rounding decides, but where nothing is rounded.
    const int is_tie = gap == 0 && is_along_axis(in->direction);
    result.is_ambiguous |= fabs(gap) <= hit.t_tolerance && !is_tie;
    const u32 found_at = hit.sphere == ORACLE_NO_SPHERE ? 0 : positions[hit.sphere];
    const u32 id = way.is_position ? in->node.first + found_at : ids[found_at];
    if (gap < 0 || (way.forgets_hit && gap < INFINITY) ||
        (is_tie && wins_tie(id, in->sphere, way))) {
        result.t = way.keeps_distance ? (double)in->t : hit.t;
        result.t_tolerance = hit.t_tolerance;
        result.sphere = way.keeps_sphere ? in->sphere : id;
    }
    return result;
}

// ---- A search in a loop -------------------------------------------------------------------------

// How a loop over the leaf decides whether a distance takes the place of the one so far.
typedef enum Comparison {
    NEARER,
    NOT_FARTHER,     // t <= hit->t: a miss as far as no hit so far, too
    LOWER_TOO,       // and its number must be lower
    OR_LOWER,        // or its number is lower
    FARTHER,         // t > hit->t: misses, which are infinitely far, win
    FARTHER_HIT,     // the same, but misses are passed over: no hit so far stays for ever
    FARTHER_OR_ANY,  // the same, but in place of no hit so far comes any
} Comparison;

typedef struct Loop {
    Comparison comparison;
    int lower_wins;      // of equal distances that of the lower number, as it should
    int higher_wins;     // or of the higher one
    int asks_position;   // it asks the sphere whose id is the position in sphere_ids,
    int keeps_position;  // and keeps the position
    int from_start;      // it runs over the first ids of the tree
    int first_ends;      // it ends with the first that takes a place
    int keeps_t;         // the distance is not set: each is held against that of before
    int keeps_start;     // or keeps one of them, the leaf's k-th for its own k-th id
} Loop;

// Does a distance take the place of the one so far?
static int takes(Loop loop, double t, u32 id, const LeafHit *so_far)
{
    if (loop.comparison == NOT_FARTHER) {
        return t <= so_far->t;
    }
    if (loop.comparison == LOWER_TOO) {
        return t < INFINITY && t <= so_far->t && id < so_far->sphere;
    }
    if (loop.comparison == OR_LOWER) {
        return t < INFINITY && (t < so_far->t || id < so_far->sphere);
    }
    if (t == so_far->t && t < INFINITY) {
        return (loop.lower_wins && id < so_far->sphere) ||
               (loop.higher_wins && id > so_far->sphere);
    }
    switch (loop.comparison) {
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

static LeafHit looped(const Inputs07 *inputs, int i, Loop loop)
{
    static const OracleRules3D right = {0};
    const SearchJob *in = &inputs->leaves[i];
    const OracleRay ray = oracle3d_given_ray(in->origin, in->direction, 0);
    const u32 first = loop.from_start ? 0 : in->node.first;
    LeafHit result = {in->sphere, in->t, 0, 0};
    for (u32 at = first; at < first + in->node.n_spheres; at++) {
        const u32 id = inputs->leaf_ids[at];
        const Sphere sphere = inputs->leaf_spheres[loop.asks_position ? at : id];
        const OracleRoot root = oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &right);
        result.is_ambiguous |= root.is_possible != root.is_certain;
        const u32 compared = loop.keeps_position && loop.asks_position ? at : id;
        const double tolerance = isinf(root.t) ? 0 : root.t_high - root.t_low;
        const double gap = isinf(root.t) ? INFINITY : fabs(root.t - result.t);
        result.is_ambiguous |= gap <= tolerance && !is_along_axis(in->direction);
        if (takes(loop, root.t, compared, &result)) {
            result.t = loop.keeps_t ? result.t : root.t;
            result.t_tolerance = loop.keeps_t ? 0 : tolerance;
            result.sphere = loop.keeps_position ? at
                            : loop.keeps_start  ? inputs->leaf_ids[at - first]
                                                : id;
            if (loop.first_ends) {
                break;
            }
        }
    }
    return result;
}

// ---- Right --------------------------------------------------------------------------------------

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
    LeafHit hit = looped(inputs, i, (Loop){.lower_wins = 1});
    if (hit.sphere != inputs->leaves[i].sphere) {
        hit.t_tolerance = 8 * 0x1p-24 * fabs((double)inputs->leaf_spheres[hit.sphere].radius);
    }
    return hit;
}

static LeafHit right_hit(const Inputs07 *inputs, int i)
{
    return is_through_middles(inputs, &inputs->leaves[i]) ? hit_through_middles(inputs, i)
                                                          : searched(inputs, i, (Way){0});
}

static int is_at(LeafHit expected, float t)
{
    return t == (float)expected.t || fabs(t - expected.t) <= expected.t_tolerance;
}

static int is_same(LeafHit expected, SearchAnswer found)
{
    return is_at(expected, found.t) && found.sphere == expected.sphere;
}

// Where a ray goes through the spheres' middles, what is right is certain: there a mistake that
// could lead to either hit explains no wrong one.
static int agrees(const Inputs07 *inputs, int i, LeafHit expected, SearchAnswer found)
{
    const LeafHit right = right_hit(inputs, i);
    return right.is_ambiguous || is_same(expected, found) ||
           (expected.is_ambiguous &&
            (!is_through_middles(inputs, &inputs->leaves[i]) || is_same(right, found)));
}

#define GIVEN                                                                                      \
    const Inputs07 *inputs = &((const Job07 *)job)->inputs;                                        \
    const SearchJob *in = &inputs->leaves[i];                                                      \
    const SearchAnswer found = ((const SearchAnswer *)answers)[i];                                 \
    const LeafHit hit = right_hit(inputs, i);                                                      \
    (void)in, (void)hit
#define IS_FOUND(expected) agrees(inputs, i, expected, found)

RIGHT(is_right_t, hit.is_ambiguous || is_at(hit, found.t))
RIGHT(is_right_sphere, hit.is_ambiguous || found.sphere == hit.sphere)

// ---- Mistakes -----------------------------------------------------------------------------------

// A hit of the leaf that is nearer by less than an epsilon, and a tie, look the same then: what is
// found is a hit, too, as far away as it says.
static int is_hit_there(const Inputs07 *inputs, const SearchJob *in, SearchAnswer found)
{
    static const OracleRules3D right = {0};
    if (found.sphere == in->sphere && found.t == in->t) {
        return found.sphere != ORACLE_NO_SPHERE;
    }
    const OracleRay ray = oracle3d_given_ray(in->origin, in->direction, 0);
    return found.sphere < N_LEAF_IDS &&
           fabs(oracle3d_root(inputs->leaf_spheres[found.sphere], &ray, ORACLE_PROJECTION, &right)
                    .t -
                (double)found.t) < HAIR / 16;
}

KNOWN_LIST(known)
{
    GIVEN;

    // What all wrong answers have to do with.
    ONLY(miss_taken, hit.sphere == ORACLE_NO_SPHERE && found.t == INFINITY,
         "a miss was taken for a hit: its t is INFINITY, as that of no hit so far, and that is no "
         "tie");
    ONLY(longest, in->node.n_spheres == N_LONG_LEAF,
         "only the longest leaf is wrong: all of its spheres count, and neither 8 bits hold how "
         "many they are nor 16 bits where they stand");
    ONLY(near_eye, hit.t < HAIR,
         "only hits very close to the eye are wrong: they count, too, without an epsilon");
    ONLY(far_away, hit.t > 1e6 && hit.t < INFINITY,
         "only hits that are very far away are wrong: they count, too; the distance of what misses "
         "is INFINITY");

    // Within a hair, what goes by ties looks the same.
    EACH(hair,
         IS_FOUND(hit) || (found.sphere != hit.sphere && found.t != (float)hit.t &&
                           fabs(found.t - hit.t) < HAIR),
         "of two hits a hair apart the nearer one is the nearer: compare without an epsilon");

    ONLY(by_hair,
         found.sphere != hit.sphere && fabs(found.t - hit.t) < HAIR &&
             is_hit_there(inputs, in, found),
         "only hits a hair apart, or just as far away, are mistaken for one another: compare "
         "without an epsilon, and at equal distances the lower id wins");

    // That no hit changes has many reasons.
    ANSWERS(unchanged, ((LeafHit){in->sphere, in->t, 0, 0}), NULL);

    ANSWERS(position, searched(inputs, i, (Way){.is_position = 1}),
            "that is a position in sphere_ids, not what stands there");
    ANSWERS(sphere_kept, searched(inputs, i, (Way){.keeps_sphere = 1}), "hit->sphere is not set");
    // Each sphere that is nearer than the hit so far is then taken, up to the last.
    ANSWERS(t_kept, searched(inputs, i, (Way){.keeps_distance = 1, .rules = {.last_wins = 1}}),
            "hit->t is not set");
    ANSWERS(t_kept_in_loop, looped(inputs, i, (Loop){.keeps_t = 1}), "hit->t is not set");
    ANSWERS(t_kept_low, looped(inputs, i, (Loop){.keeps_t = 1, .lower_wins = 1}),
            "hit->t is not set");
    ANSWERS(hit_forgotten, searched(inputs, i, (Way){.forgets_hit = 1}),
            "the hit so far was nearer: it stays");
    ANSWERS(last_missing, searched(inputs, i, (Way){.rules = {.skip_last = 1}}),
            "the last sphere of the leaf is missing", MISTAKE_MISSING_IN_CELL);
    ANSWERS(first_missing, searched(inputs, i, (Way){.rules = {.skip_first = 1}}),
            "the first sphere of the leaf is missing", MISTAKE_MISSING_IN_CELL);
    ANSWERS(one_more, searched(inputs, i, (Way){.rules = {.one_sphere_more = 1}}),
            "one sphere too many is asked, the one before the leaf's or the one behind them");
    ANSWERS(later_wins, searched(inputs, i, (Way){.rules = {.later_wins_ties = 1}}),
            "of two equally far spheres the later one won", MISTAKE_LATER_OF_EQUALS);
    ANSWERS(hit_stays, searched(inputs, i, (Way){.first_stays = 1}),
            "the hit so far stayed, where a sphere with a lower id is just as far away");
#define FIRST_WINS "that is as if the first sphere that is hit won, however far"
    ANSWERS(first_wins, searched(inputs, i, (Way){.rules = {.first_wins = 1}}), FIRST_WINS);
    ANSWERS(first_ends, looped(inputs, i, (Loop){.first_ends = 1}), FIRST_WINS);
    ANSWERS(first_ends_low, looped(inputs, i, (Loop){.first_ends = 1, .lower_wins = 1}),
            FIRST_WINS);
    ANSWERS(last_wins, searched(inputs, i, (Way){.rules = {.last_wins = 1}}),
            "that is as if the last sphere that is hit won, however far");
    ANSWERS(farthest_wins, searched(inputs, i, (Way){.rules = {.farthest_wins = 1}}),
            "that is as if the farthest sphere won");

    ANSWERS(not_farther, looped(inputs, i, (Loop){.comparison = NOT_FARTHER}),
            "of two equally far spheres the later one won, and of misses, too: t <= hit->t",
            MISTAKE_LATER_OF_EQUALS);

    ANSWERS(higher_wins, looped(inputs, i, (Loop){.higher_wins = 1}),
            "of two equally far spheres the one with the higher id won: the lower one is to");
    ANSWERS(or_lower, looped(inputs, i, (Loop){.comparison = OR_LOWER}),
            "a sphere with a lower id won, however far: ids count at equal distances only");
    ANSWERS(lower_too, looped(inputs, i, (Loop){.comparison = LOWER_TOO}),
            "a nearer sphere wins whatever its id: ids count at equal distances only");

#define FARTHER_WINS "that is as if a hit had to be farther than the one so far: t > hit->t"
    ANSWERS(farther, looped(inputs, i, (Loop){.comparison = FARTHER}), FARTHER_WINS);
    ANSWERS(farther_low, looped(inputs, i, (Loop){.comparison = FARTHER, .lower_wins = 1}),
            FARTHER_WINS);
    ANSWERS(farther_hit, looped(inputs, i, (Loop){.comparison = FARTHER_HIT}), FARTHER_WINS);
    ANSWERS(farther_hit_low, looped(inputs, i, (Loop){.comparison = FARTHER_HIT, .lower_wins = 1}),
            FARTHER_WINS);
    ANSWERS(farther_or_any, looped(inputs, i, (Loop){.comparison = FARTHER_OR_ANY}), FARTHER_WINS);

#define ASKS_POSITION "the position in sphere_ids was taken for the id of the sphere to ask"
    ANSWERS(asked, looped(inputs, i, (Loop){.asks_position = 1}), ASKS_POSITION);
    ANSWERS(asked_low, looped(inputs, i, (Loop){.asks_position = 1, .lower_wins = 1}),
            ASKS_POSITION);
    ANSWERS(asked_kept, looped(inputs, i, (Loop){.asks_position = 1, .keeps_position = 1}),
            ASKS_POSITION);
    ANSWERS(asked_kept_low,
            looped(inputs, i, (Loop){.asks_position = 1, .keeps_position = 1, .lower_wins = 1}),
            ASKS_POSITION);
    ANSWERS(kept_low, looped(inputs, i, (Loop){.keeps_position = 1, .lower_wins = 1}),
            "hit->sphere is a position in sphere_ids, not what stands there");

#define KEEPS_START                                                                                \
    "the id that is kept is not that of the sphere that was asked: both are at node.first + i"
    ANSWERS(keeps_start, looped(inputs, i, (Loop){.keeps_start = 1}), KEEPS_START);
    ANSWERS(keeps_start_low, looped(inputs, i, (Loop){.keeps_start = 1, .lower_wins = 1}),
            KEEPS_START);

#define FIRST_IDS "the first ids of the tree were asked: the leaf's begin at node.first"
    ANSWERS(from_start, looped(inputs, i, (Loop){.from_start = 1}), FIRST_IDS);
    ANSWERS(from_start_low, looped(inputs, i, (Loop){.from_start = 1, .lower_wins = 1}), FIRST_IDS);
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

// "nothing", or "sphere 3 at t = 4.5".
static Words hit_words(u32 sphere, double t)
{
    return sphere != ORACLE_NO_SPHERE ? words("sphere %u at t = %.9g", sphere, t)
           : t == INFINITY            ? words("nothing")
                                      : words("no sphere at t = %.9g", t);
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("a leaf of %u sphere%s, its ids from %u on, ray from %s along %s, hit so "
                       "far: %s: found %s, expected %s",
                       in->node.n_spheres, plural(in->node.n_spheres), in->node.first,
                       words_vec3(in->origin, 6).text, words_vec3(in->direction, 7).text,
                       hit_words(in->sphere, in->t).text, hit_words(found.sphere, found.t).text,
                       hit_words(hit.sphere, hit.t).text);
}

const Function leaf_nearest_07 = {"leaves",
                                  N_LEAVES,
                                  sizeof(SearchAnswer),
                                  KNOWING(is_right_t, describe, known),
                                  .knows_constant = 1,
                                  .is_known_by_range = 1};
const Function leaf_ids_07 = {"leaves",
                              N_LEAVES,
                              sizeof(SearchAnswer),
                              KNOWING(is_right_sphere, describe, known),
                              .knows_constant = 1,
                              .is_known_by_range = 1};
