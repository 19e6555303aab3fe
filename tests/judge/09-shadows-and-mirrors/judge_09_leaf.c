// Lab 09: is anything of a leaf in the way of a ray? Judged, with how many were asked. The leaves
// are rolled in judge_09_leaves.c.
#include "judge_09.h"

#include "message.h"
#include "words.h"

#include <math.h>

static const OracleRules3D right = {0};

// Is it along an axis, where nothing is rounded?
static int is_exact(const BlockJob *in)
{
    const Vec3 d = in->direction;
    return (d.x == 0) + (d.y == 0) + (d.z == 0) == 2;
}

// ---- What blocks --------------------------------------------------------------------------------

typedef enum Blocks { NO, YES, EITHER } Blocks;

typedef struct BlockMistake {
    Cause cause;
    int any_distance;    // t_max does not count
    int behind_end;      // hits behind the end block, not those before it
    int miss_blocks;     // so does what is not hit at all
    int first_only;      // of the leaf's spheres
    int last_decides;    // of them
    int all_must_block;  // each
    int is_position;     // sphere i is spheres[i], whatever the ids say
    int from_start;      // the first ids of the tree are asked
    int one_more;        // the one behind the leaf is asked, too
    int skips_first;     // of the leaf
    int skips_last;
    int hit_decides;          // the first sphere that is hit at all
    int at_one, at_root;      // 1 or the root of t_max is taken for the end of the ray
    int at_end;               // a hit at t_max itself counts
    int misses_long;          // the longest leaf blocks nothing
    int not_from_inside;      // nor do spheres in which the ray starts
    int not_negative;         // nor those with a negative radius
    double start, end;        // hits so near to them, as a share of t_max, do not count
    double start_by, end_by;  // the same in scene units
} BlockMistake;

#define NEAR_START {.says = "hits very near to the start of the ray count, too, without an epsilon"}
#define NEAR_END {.says = "hits very near to the end of the ray count, too, without an epsilon"}

enum { ANY_DISTANCE = 1 };
static const BlockMistake mistakes[] = {
    {.cause = {0}},
    [ANY_DISTANCE] = {{.says = "a hit behind the ray's end blocks nothing: t_max"},
                      .any_distance = 1},
    {{.says =
          "hits behind the ray's end block, those before it do not: the comparison is inverted"},
     .behind_end = 1},
    {{.says = "hits behind the ray's end and misses block: the comparison is inverted"},
     .behind_end = 1,
     .miss_blocks = 1},
    {{.says = "only the leaf's first sphere decides"}, .first_only = 1},
    {{.says = "only the leaf's last sphere decides"}, .last_decides = 1},
    {{.says = "one sphere in the way is enough, not all must be"}, .all_must_block = 1},
    {{.says = "what stands in sphere_ids was not looked up: i is a position, not an id"},
     .is_position = 1},
    {{.says = "the first ids of the tree were asked: the leaf's begin at node.first"},
     .from_start = 1},
    {{.says = "one sphere too many was asked, the one behind the end of the leaf"}, .one_more = 1},
    {{.says = "the leaf's first sphere was not asked"}, .skips_first = 1},
    {{.says = "a hit at the end itself blocks nothing: it counts when t < t_max"}, .at_end = 1},
    {{.says = "only the longest leaf is wrong: all of its spheres count, and neither 8 bits hold "
              "how many they are nor 16 bits where they stand"},
     .misses_long = 1},
    {{.says = "the leaf's last sphere was not asked"}, .skips_last = 1},
    {{.says = "the first sphere that is hit decides, wherever: behind the ray's end it blocks "
              "nothing, and the next one may"},
     .hit_decides = 1},
    {{.says = "the ray ends at t_max, not at 1: its direction is a unit vector"}, .at_one = 1},
    {{.says = "a distance is compared with a square: t and t_max are both distances"},
     .at_root = 1},
    {{.says = "a sphere around the start of the ray is in its way, too: from inside it is hit"},
     .not_from_inside = 1},
    {{.says = "a sphere with a negative radius is in the way, too, where the ray leaves it"},
     .not_negative = 1},
    {NEAR_START, .start = 1.5 * HAIR},
    {NEAR_START, .start = 1.5 * LEAST_HAIR},
    {NEAR_START, .start_by = 1e-2},
    {NEAR_START, .start_by = 1e-3},
    {NEAR_START, .start_by = 1e-4},
    {NEAR_START, .start_by = 1e-5},
    {NEAR_START, .start_by = 1e-6},
    {NEAR_END, .end = 1.5 * HAIR},
    {NEAR_END, .end = 1.5 * LEAST_HAIR},
    {NEAR_END, .end_by = 1e-2},
    {NEAR_END, .end_by = 1e-3},
    {NEAR_END, .end_by = 1e-4},
    {NEAR_END, .end_by = 1e-5},
    {NEAR_END, .end_by = 1e-6},
};

static OracleRay ray_of(const BlockJob *in)
{
    return oracle3d_given_ray(in->origin, in->direction, 0);
}

// Does a mistake leave this sphere out, wherever it is hit?
static int is_left_out(const Sphere *sphere, const OracleRay *ray, const BlockMistake *mistake)
{
    const OracleVector centre = {sphere->x, sphere->y, sphere->z};
    const double distance = vector_length(vector_minus(centre, ray->origin));
    return (mistake->not_negative && sphere->radius < 0) ||
           (mistake->not_from_inside && distance < fabs(sphere->radius));
}

// Does the sphere in place `at` of the ids block, by a mistake's rules?
static Blocks sphere_blocks(const Job09 *job, const BlockJob *in, u32 at,
                            const BlockMistake *mistake)
{
    const OracleRay ray = ray_of(in);
    const u32 id = mistake->is_position ? at : job->block_ids[at];
    const OracleRoot root = oracle3d_root(job->block_spheres[id], &ray, ORACLE_PROJECTION, &right);
    if (is_left_out(&job->block_spheres[id], &ray, mistake)) {
        return NO;
    }
    if (mistake->miss_blocks && !root.is_possible) {
        return YES;
    }
    if (mistake->behind_end) {
        return root.is_certain && root.t_low > in->t_max ? YES : NO;
    }
    const double start = mistake->start * in->t_max + mistake->start_by;
    const double end = mistake->any_distance ? INFINITY
                       : mistake->at_one     ? 1
                       : mistake->at_root    ? sqrt(in->t_max)
                                             : in->t_max * (1 - mistake->end) - mistake->end_by;
    if (root.is_possible && is_exact(in)) {
        return root.t < end || (mistake->at_end && root.t == end) ? YES : NO;
    }
    if (!root.is_possible || root.t_low >= end || root.t_high < start) {
        return NO;
    }
    return root.is_certain && root.t_high < end ? YES : EITHER;
}

static Blocks leaf_blocks(const Job09 *job, int i, const BlockMistake *mistake)
{
    const BlockJob *in = &job->blocks[i];
    const u32 n_all = mistake->misses_long && i == LONG_LEAF ? 0 : in->node.n_spheres;
    const u32 n = mistake->skips_last && n_all > 0 ? n_all - 1 : n_all;
    const u32 start = mistake->from_start ? 0 : in->node.first;
    const u32 skipped = mistake->skips_first ? 1 : mistake->last_decides && n > 0 ? n - 1 : 0;
    const u32 end = mistake->first_only && n > 1 ? 1 : n + (mistake->one_more ? 1 : 0);
    Blocks any = NO, all = end > skipped ? YES : NO;
    for (u32 k = skipped; k < end; k++) {
        const Blocks own = sphere_blocks(job, in, start + k, mistake);
        const Blocks is_hit =
            mistake->hit_decides ? sphere_blocks(job, in, start + k, &mistakes[ANY_DISTANCE]) : NO;
        if (is_hit != NO) {
            return is_hit == YES ? own : EITHER;
        }
        any = own == YES || any == YES ? YES : own == EITHER ? EITHER : any;
        all = own == NO || all == NO ? NO : own == EITHER ? EITHER : all;
    }
    return mistake->all_must_block ? all : any;
}

static int block_agrees(const void *job, int i, const void *answers, int mistake)
{
    const Blocks expected = leaf_blocks(job, i, &mistakes[mistake]);
    return expected == EITHER ||
           ((const BlockAnswer *)answers)[i].is_blocked == (expected == YES ? 1 : 0);
}

static char *describe_block(const void *pointer, int i, const void *answers)
{
    const BlockJob *in = &((const Job09 *)pointer)->blocks[i];
    return message_new(
        "a leaf of %u sphere%s, its ids from %u on, ray from %s along %s up to %.9g: "
        "found %u, expected %d",
        in->node.n_spheres, plural(in->node.n_spheres), in->node.first,
        words_vec3(in->origin, 6).text, words_vec3(in->direction, 6).text, in->t_max,
        ((const BlockAnswer *)answers)[i].is_blocked, leaf_blocks(pointer, i, &mistakes[0]) == YES);
}

const Function block_09 = {"blocks", N_BLOCKS, sizeof(BlockAnswer),
                           COMPARED(block_agrees, describe_block, mistakes)};

// ---- How many are asked -------------------------------------------------------------------------

// Of the leaf's spheres in the way: the first and the last. n_spheres where none is.
typedef struct Blockers {
    u32 first, last;
    int is_unsure;
} Blockers;

static Blockers blockers_of(const Job09 *job, int i)
{
    const BlockJob *in = &job->blocks[i];
    const u32 n = in->node.n_spheres;
    Blockers blockers = {.first = n, .last = n};
    for (u32 k = 0; k < n; k++) {
        const Blocks own = sphere_blocks(job, in, in->node.first + k, &mistakes[0]);
        blockers.is_unsure |= own == EITHER;
        if (own == YES) {
            blockers.first = blockers.first == n ? k : blockers.first;
            blockers.last = k;
        }
    }
    return blockers;
}

enum { EARLY_ASKS_ALL = 1, EARLY_UNCOUNTED, EARLY_ONE_LATE, EARLY_WRONG };

// In either order: each up to the one that is found first.
static int early_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const Job09 *job = pointer;
    const u32 n = job->blocks[i].node.n_spheres;
    const u32 found = ((const BlockAnswer *)answers)[i].n_tests;
    const Blockers blockers = blockers_of(job, i);
    if (mistake == EARLY_ASKS_ALL) {
        return found == n;
    }
    if (mistake == EARLY_UNCOUNTED) {
        return found == 0;
    }
    if (mistake == EARLY_ONE_LATE) {
        return blockers.is_unsure || found == (blockers.first + 2 < n ? blockers.first + 2 : n);
    }
    const int is_blocked = ((const BlockAnswer *)answers)[i].is_blocked != 0;
    if (mistake == EARLY_WRONG && is_blocked != (blockers.first < n)) {
        return 1;
    }
    if (blockers.is_unsure || blockers.first == n) {
        return blockers.is_unsure || found == n;
    }
    return found == blockers.first + 1 || found == n - blockers.last;
}

static const Cause early_causes[] = {
    {0},
    [EARLY_ASKS_ALL] = {.says = "each sphere of the leaf was asked, though one in the way is "
                                "enough"},
    [EARLY_UNCOUNTED] = {.says = "no call is counted: intersect_sphere counts, or `work` was not "
                                 "passed on to it"},
    [EARLY_ONE_LATE] = {.says = "one sphere more was asked after the one in the way: the search "
                                "ends at once"},
    [EARLY_WRONG] = {.says = "the answer is wrong there, too: blocks-before and blocks-edges say "
                             "more"},
};

static char *describe_early(const void *pointer, int i, const void *answers)
{
    const Job09 *job = pointer;
    const u32 n = job->blocks[i].node.n_spheres, first = blockers_of(job, i).first;
    const Words which =
        first < n ? words("number %u is in the way", first + 1) : words("none is in the way");
    return message_new("a leaf of %u sphere%s, of which %s: intersect_sphere was called %u time%s, "
                       "expected %u",
                       n, plural(n), which.text, ((const BlockAnswer *)answers)[i].n_tests,
                       plural(((const BlockAnswer *)answers)[i].n_tests),
                       first < n ? first + 1 : n);
}

const Function block_early_09 = {"blocks", N_BLOCKS, sizeof(BlockAnswer),
                                 COMPARED(early_agrees, describe_early, early_causes)};
