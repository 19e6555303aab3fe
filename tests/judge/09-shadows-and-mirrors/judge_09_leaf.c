// Lab 09: is anything of a leaf in the way of a ray? Judged, with how many were asked. The leaves
// are rolled in judge_09_leaves.c.
#include "judge_09.h"

#include "message.h"
#include "words.h"

#include <math.h>

typedef enum Blocks { NO, YES, EITHER } Blocks;

#define GIVEN                                                                                      \
    const Job09 *of = job;                                                                         \
    const BlockJob *in = &of->blocks[i];                                                           \
    const BlockAnswer found = ((const BlockAnswer *)answers)[i]
#define IS_FOUND(blocks) ((blocks) == EITHER || found.is_blocked == ((blocks) == YES))

// ---- Right --------------------------------------------------------------------------------------

static OracleRay ray_of(const BlockJob *in)
{
    return oracle3d_given_ray(in->origin, in->direction, 0);
}

static OracleRoot root_of(const BlockJob *in, Sphere sphere)
{
    static const OracleRules3D right = {0};
    const OracleRay ray = ray_of(in);
    return oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &right);
}

// Is it along an axis, where nothing is rounded?
static int is_exact(const BlockJob *in)
{
    const Vec3 d = in->direction;
    return (d.x == 0) + (d.y == 0) + (d.z == 0) == 2;
}

// Is the ray blocked between these distances?
static Blocks between(const BlockJob *in, Sphere sphere, double start, double end)
{
    const OracleRoot root = root_of(in, sphere);
    if (root.is_possible && is_exact(in)) {
        return root.t < end ? YES : NO;
    }
    if (!root.is_possible || root.t_low >= end || root.t_high < start) {
        return NO;
    }
    return root.is_certain && root.t_high < end ? YES : EITHER;
}

// Does the sphere in place `at` of the ids block?
typedef Blocks Asked(const Job09 *of, const BlockJob *in, u32 at);
#define SPHERE(name, expression)                                                                   \
    static Blocks name(const Job09 *of, const BlockJob *in, u32 at)                                \
    {                                                                                              \
        const Sphere sphere = of->block_spheres[of->block_ids[at]];                                \
        (void)sphere;                                                                              \
        return expression;                                                                         \
    }
SPHERE(right, between(in, sphere, 0, in->t_max))

// Of n spheres from a place on.
static Blocks any_of(const Job09 *of, const BlockJob *in, Asked *asked, u32 first, u32 n)
{
    Blocks any = NO;
    for (u32 at = first; at < first + n && any != YES; at++) {
        const Blocks own = asked(of, in, at);
        any = own != NO ? own : any;
    }
    return any;
}

static Blocks leaf_blocks(const Job09 *of, const BlockJob *in, Asked *asked)
{
    return any_of(of, in, asked, in->node.first, in->node.n_spheres);
}

#define BLOCKS leaf_blocks(of, in, right)

RIGHT(is_right, IS_FOUND(BLOCKS))

// ---- Mistakes -----------------------------------------------------------------------------------

// By what a sphere is asked.
#define ASKS(name, expression, ...)                                                                \
    SPHERE(name##_sphere, expression)                                                              \
    ANSWERS(name, leaf_blocks(of, in, name##_sphere), __VA_ARGS__)

static int is_behind(const BlockJob *in, OracleRoot root)
{
    return root.is_certain && root.t_low > in->t_max;
}

static int is_from_inside(const BlockJob *in, Sphere sphere)
{
    const OracleVector centre = {sphere.x, sphere.y, sphere.z};
    return vector_length(vector_minus(centre, ray_of(in).origin)) < fabs(sphere.radius);
}

ASKS(any_distance, between(in, sphere, 0, INFINITY),
     "a hit behind the ray's end blocks nothing: t_max")
ASKS(behind_end, is_behind(in, root_of(in, sphere)) ? YES : NO,
     "hits behind the ray's end block, those before it do not: the comparison is inverted")
ASKS(behind_or_miss,
     !root_of(in, sphere).is_possible || is_behind(in, root_of(in, sphere)) ? YES : NO,
     "hits behind the ray's end and misses block: the comparison is inverted")
ASKS(position, between(in, of->block_spheres[at], 0, in->t_max),
     "what stands in sphere_ids was not looked up: i is a position, not an id")
ASKS(at_end, is_exact(in) && root_of(in, sphere).t == in->t_max ? YES : right(of, in, at),
     "a hit at the end itself blocks nothing: it counts when t < t_max")
ASKS(at_one, between(in, sphere, 0, 1),
     "the ray ends at t_max, not at 1: its direction is a unit vector")
ASKS(at_root, between(in, sphere, 0, sqrt(in->t_max)),
     "a distance is compared with a square: t and t_max are both distances")
ASKS(not_from_inside, is_from_inside(in, sphere) ? NO : right(of, in, at),
     "a sphere around the start of the ray is in its way, too: from inside it is hit")
ASKS(not_negative, sphere.radius < 0 ? NO : right(of, in, at),
     "a sphere with a negative radius is in the way, too, where the ray leaves it")

// By an epsilon of whatever size, in scene units or as a share of the ray.
#define LARGEST_EPSILON fmax(0.01, 1.5 * HAIR * in->t_max)
SPHERE(not_at_start, between(in, sphere, LARGEST_EPSILON, in->t_max))
SPHERE(not_at_end, between(in, sphere, 0, in->t_max - LARGEST_EPSILON))
ONLY(near_start, !found.is_blocked && IS_FOUND(leaf_blocks(of, in, not_at_start)),
     "hits very near to the start of the ray count, too, without an epsilon")
ONLY(near_end, !found.is_blocked && IS_FOUND(leaf_blocks(of, in, not_at_end)),
     "hits very near to the end of the ray count, too, without an epsilon")

SPHERE(not_at_ends, between(in, sphere, LARGEST_EPSILON, in->t_max - LARGEST_EPSILON))
ONLY(near_ends, !found.is_blocked && IS_FOUND(leaf_blocks(of, in, not_at_ends)),
     "hits very near to the start or to the end of the ray count, too, without an epsilon")

// By which spheres are asked.
#define FIRST in->node.first
#define N in->node.n_spheres
#define SOME_OF(first, n) any_of(of, in, right, first, n)

static Blocks all_of(const Job09 *of, const BlockJob *in)
{
    Blocks all = N > 0 ? YES : NO;
    for (u32 at = FIRST; at < FIRST + N && all != NO; at++) {
        const Blocks own = right(of, in, at);
        all = own != YES ? own : all;
    }
    return all;
}

// The first one that is hit at all, wherever.
static Blocks hit_decides_of(const Job09 *of, const BlockJob *in)
{
    for (u32 at = FIRST; at < FIRST + N; at++) {
        const Blocks is_hit = any_distance_sphere(of, in, at);
        if (is_hit != NO) {
            return is_hit == YES ? right(of, in, at) : EITHER;
        }
    }
    return NO;
}

ANSWERS(first_only, SOME_OF(FIRST, N > 1 ? 1 : N), "only the leaf's first sphere decides")
ANSWERS(last_only, N > 1 ? SOME_OF(FIRST + N - 1, 1) : BLOCKS,
        "only the leaf's last sphere decides")
ANSWERS(all_must, all_of(of, in), "one sphere in the way is enough, not all must be")
ANSWERS(hit_decides, hit_decides_of(of, in),
        "the first sphere that is hit decides, wherever: behind the ray's end it blocks nothing, "
        "and the next one may")
ANSWERS(from_start, SOME_OF(0, N),
        "the first ids of the tree were asked: the leaf's begin at node.first")
ANSWERS(one_more, SOME_OF(FIRST, N + 1),
        "one sphere too many was asked, the one behind the end of the leaf")
ANSWERS(none_blocks, NO,
        "no leaf blocks: does the loop come to the leaf's spheres, and is 1 returned?")
ANSWERS(first_skipped, N > 0 ? SOME_OF(FIRST + 1, N - 1) : NO,
        "the leaf's first sphere was not asked")
ANSWERS(last_skipped, N > 0 ? SOME_OF(FIRST, N - 1) : NO, "the leaf's last sphere was not asked")
ANSWERS(long_missed, i == LONG_LEAF ? NO : BLOCKS,
        "only the longest leaf is wrong: all of its spheres count, and neither 8 bits hold how "
        "many they are nor 16 bits where they stand")

static const Known *const known[] = {
    &any_distance, &behind_end,      &behind_or_miss, &position,   &at_end,   &at_one,
    &at_root,      &not_from_inside, &not_negative,   &near_start, &near_end, &first_only,
    &last_only,    &all_must,        &hit_decides,    &from_start, &one_more, &first_skipped,
    &last_skipped, &long_missed,     &near_ends,      &none_blocks};

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new(
        "a leaf of %u sphere%s, its ids from %u on, ray from %s along %s up to %.9g: "
        "found %u, expected %d",
        N, plural(N), FIRST, words_vec3(in->origin, 6).text, words_vec3(in->direction, 6).text,
        in->t_max, found.is_blocked, BLOCKS == YES);
}

const Function block_09 = {"blocks", N_BLOCKS, sizeof(BlockAnswer),
                           KNOWING(is_right, describe, known), .knows_constant = 1};
#undef IS_FOUND

// ---- How many are asked -------------------------------------------------------------------------

#define IS_FOUND(n) (found.n_tests == (n))

// Of the leaf's spheres in the way: the first and the last. n_spheres where none is.
typedef struct Blockers {
    u32 first, last;
    int is_unsure;
} Blockers;

static Blockers blockers_of(const Job09 *of, const BlockJob *in)
{
    Blockers blockers = {.first = N, .last = N};
    for (u32 k = 0; k < N; k++) {
        const Blocks own = right(of, in, FIRST + k);
        blockers.is_unsure |= own == EITHER;
        if (own == YES) {
            blockers.first = blockers.first == N ? k : blockers.first;
            blockers.last = k;
        }
    }
    return blockers;
}

#define BLOCKERS blockers_of(of, in)

// In either order: each up to the one that is found first.
RIGHT(is_early, BLOCKERS.is_unsure || (BLOCKERS.first == N ? IS_FOUND(N)
                                                           : IS_FOUND(BLOCKERS.first + 1) ||
                                                                 IS_FOUND(N - BLOCKERS.last)))

// Does a leaf block, in whichever input? Then spheres were asked, counted or not.
static int is_any_blocked(const void *answers)
{
    int i = 0;
    while (i < N_BLOCKS && ((const BlockAnswer *)answers)[i].is_blocked == 0) {
        i++;
    }
    return i < N_BLOCKS;
}

ANSWERS(asks_all, N, "each sphere of the leaf was asked, though one in the way is enough")
EACH(uncounted, IS_FOUND(0) && is_any_blocked(answers),
     "leaves block, but no call is counted: intersect_sphere counts, if `work` is passed on to it")
EACH(unasked, IS_FOUND(0) && !is_any_blocked(answers),
     "no leaf blocks, and no sphere was asked: from where to where does the loop run?")
ANSWERS(only_first, N > 0 ? 1 : 0,
        "the loop ends after its first sphere: where that is not in the way, the next one is asked")
EACH(one_late, BLOCKERS.is_unsure || IS_FOUND(BLOCKERS.first + 2 < N ? BLOCKERS.first + 2 : N),
     "one sphere more was asked after the one in the way: the search ends at once")
ONLY(wrong_too, (found.is_blocked != 0) != (BLOCKERS.first < N),
     "the answer is wrong there, too: blocks-before and blocks-edges say more")

static const Known *const early_known[] = {&asks_all, &uncounted, &unasked,
                                           &one_late, &wrong_too, &only_first};

static char *describe_early(const void *job, int i, const void *answers)
{
    GIVEN;
    const u32 first = BLOCKERS.first;
    const Words which =
        first < N ? words("number %u is in the way", first + 1) : words("none is in the way");
    return message_new("a leaf of %u sphere%s, of which %s: intersect_sphere was called %u time%s, "
                       "expected %u",
                       N, plural(N), which.text, found.n_tests, plural(found.n_tests),
                       first < N ? first + 1 : N);
}

const Function block_early_09 = {"blocks", N_BLOCKS, sizeof(BlockAnswer),
                                 KNOWING(is_early, describe_early, early_known),
                                 .knows_constant = 1};
