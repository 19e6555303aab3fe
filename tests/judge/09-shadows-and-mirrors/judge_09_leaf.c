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

// The sphere in place `at` of the ids.
static Sphere sphere_at(const Job09 *of, u32 at)
{
    return of->block_spheres[of->block_ids[at]];
}

static Blocks right(const Job09 *of, const BlockJob *in, u32 at)
{
    return between(in, sphere_at(of, at), 0, in->t_max);
}

// Does one of two block?
static Blocks either(Blocks a, Blocks b)
{
    return a == YES || b == NO ? a : b;
}

// Does one of n spheres from a place on, between these distances?
static Blocks any_of(const Job09 *of, const BlockJob *in, u32 first, u32 n, double start,
                     double end)
{
    Blocks any = NO;
    for (u32 at = first; at < first + n && any != YES; at++) {
        any = either(any, between(in, sphere_at(of, at), start, end));
    }
    return any;
}

static Blocks some_of(const Job09 *of, const BlockJob *in, u32 first, u32 n)
{
    return any_of(of, in, first, n, 0, in->t_max);
}

static Blocks leaf_blocks(const Job09 *of, const BlockJob *in)
{
    return some_of(of, in, in->node.first, in->node.n_spheres);
}

RIGHT(is_right, IS_FOUND(leaf_blocks(of, in)))

// ---- Mistakes -----------------------------------------------------------------------------------

// By what the leaf's `sphere` in place `at` of the ids is asked, of which `root` is met.
#define ASKS(name, blocks, ...)                                                                    \
    for (u32 at = first; number == 0 && at < first + n && any != YES; at++) {                      \
        const Sphere sphere = sphere_at(of, at);                                                   \
        const OracleRoot root = root_of(in, sphere);                                               \
        (void)root;                                                                                \
        any = either(any, blocks);                                                                 \
    }                                                                                              \
    ANSWERS(name, any, __VA_ARGS__)

static int is_behind(const BlockJob *in, OracleRoot root)
{
    return root.is_certain && root.t_low > in->t_max;
}

static int is_from_inside(const BlockJob *in, Sphere sphere)
{
    const OracleVector centre = {sphere.x, sphere.y, sphere.z};
    return vector_length(vector_minus(centre, ray_of(in).origin)) < fabs(sphere.radius);
}

// By which spheres are asked.
static Blocks all_of(const Job09 *of, const BlockJob *in)
{
    const u32 first = in->node.first, n = in->node.n_spheres;
    Blocks all = n > 0 ? YES : NO;
    for (u32 at = first; at < first + n && all != NO; at++) {
        const Blocks own = right(of, in, at);
        all = own != YES ? own : all;
    }
    return all;
}

// The first one that is hit at all, wherever.
static Blocks hit_decides_of(const Job09 *of, const BlockJob *in)
{
    const u32 first = in->node.first, n = in->node.n_spheres;
    for (u32 at = first; at < first + n; at++) {
        const Blocks is_hit = between(in, sphere_at(of, at), 0, INFINITY);
        if (is_hit != NO) {
            return is_hit == YES ? right(of, in, at) : EITHER;
        }
    }
    return NO;
}

KNOWN_LIST(known)
{
    GIVEN;
    const u32 first = in->node.first, n = in->node.n_spheres;
    const double epsilon = fmax(0.01, 1.5 * HAIR * in->t_max);  // the largest that is one
    Blocks any = NO;

    ASKS(any_distance, between(in, sphere, 0, INFINITY),
         "a hit behind the ray's end blocks nothing: t_max");
    ASKS(behind_end, is_behind(in, root) ? YES : NO,
         "hits behind the ray's end block, those before it do not: the comparison is inverted");
    ASKS(behind_or_miss, !root.is_possible || is_behind(in, root) ? YES : NO,
         "hits behind the ray's end and misses block: the comparison is inverted");
    ASKS(position, between(in, of->block_spheres[at], 0, in->t_max),
         "what stands in sphere_ids was not looked up: i is a position, not an id");
    ASKS(at_end, is_exact(in) && root.t == in->t_max ? YES : right(of, in, at),
         "a hit at the end itself blocks nothing: it counts when t < t_max");
    ASKS(at_one, between(in, sphere, 0, 1),
         "the ray ends at t_max, not at 1: its direction is a unit vector");
    ASKS(at_root, between(in, sphere, 0, sqrt(in->t_max)),
         "a distance is compared with a square: t and t_max are both distances");
    ASKS(not_from_inside, is_from_inside(in, sphere) ? NO : right(of, in, at),
         "a sphere around the start of the ray is in its way, too: from inside it is hit");
    ASKS(not_negative, sphere.radius < 0 ? NO : right(of, in, at),
         "a sphere with a negative radius is in the way, too, where the ray leaves it");

    // By an epsilon of whatever size, in scene units or as a share of the ray.
    ONLY(near_start, !found.is_blocked && IS_FOUND(any_of(of, in, first, n, epsilon, in->t_max)),
         "hits very near to the start of the ray count, too, without an epsilon");
    ONLY(near_end, !found.is_blocked && IS_FOUND(any_of(of, in, first, n, 0, in->t_max - epsilon)),
         "hits very near to the end of the ray count, too, without an epsilon");
    ONLY(near_ends,
         !found.is_blocked && IS_FOUND(any_of(of, in, first, n, epsilon, in->t_max - epsilon)),
         "hits very near to the start or to the end of the ray count, too, without an epsilon");

    ANSWERS(first_only, some_of(of, in, first, n > 1 ? 1 : n),
            "only the leaf's first sphere decides");
    ANSWERS(last_only, n > 1 ? some_of(of, in, first + n - 1, 1) : leaf_blocks(of, in),
            "only the leaf's last sphere decides");
    ANSWERS(all_must, all_of(of, in), "one sphere in the way is enough, not all must be");
    ANSWERS(hit_decides, hit_decides_of(of, in),
            "the first sphere that is hit decides, wherever: behind the ray's end it blocks "
            "nothing, and the next one may");
    ANSWERS(from_start, some_of(of, in, 0, n),
            "the first ids of the tree were asked: the leaf's begin at node.first");
    ANSWERS(one_more, some_of(of, in, first, n + 1),
            "one sphere too many was asked, the one behind the end of the leaf");
    ANSWERS(none_blocks, NO,
            "no leaf blocks: does the loop come to the leaf's spheres, and is 1 returned?");
    ANSWERS(first_skipped, n > 0 ? some_of(of, in, first + 1, n - 1) : NO,
            "the leaf's first sphere was not asked");
    ANSWERS(last_skipped, n > 0 ? some_of(of, in, first, n - 1) : NO,
            "the leaf's last sphere was not asked");
    ANSWERS(long_missed, i == LONG_LEAF ? NO : leaf_blocks(of, in),
            "only the longest leaf is wrong: all of its spheres count, and neither 8 bits hold how "
            "many they are nor 16 bits where they stand");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const u32 n = in->node.n_spheres;
    return message_new(
        "a leaf of %u sphere%s, its ids from %u on, ray from %s along %s up to %.9g: "
        "found %u, expected %d",
        n, plural(n), in->node.first, words_vec3(in->origin, 6).text,
        words_vec3(in->direction, 6).text, in->t_max, found.is_blocked, leaf_blocks(of, in) == YES);
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
    const u32 n = in->node.n_spheres;
    Blockers blockers = {.first = n, .last = n};
    for (u32 k = 0; k < n; k++) {
        const Blocks own = right(of, in, in->node.first + k);
        blockers.is_unsure |= own == EITHER;
        if (own == YES) {
            blockers.first = blockers.first == n ? k : blockers.first;
            blockers.last = k;
        }
    }
    return blockers;
}

// In either order: each up to the one that is found first.
static int is_early_by(Blockers blockers, u32 n, u32 found)
{
    return blockers.is_unsure ||
           (blockers.first == n ? found == n
                                : found == blockers.first + 1 || found == n - blockers.last);
}

RIGHT(is_early, is_early_by(blockers_of(of, in), in->node.n_spheres, found.n_tests))

// Does a leaf block, in whichever input? Then spheres were asked, counted or not.
static int is_any_blocked(const void *answers)
{
    int i = 0;
    while (i < N_BLOCKS && ((const BlockAnswer *)answers)[i].is_blocked == 0) {
        i++;
    }
    return i < N_BLOCKS;
}

KNOWN_LIST(early_known)
{
    GIVEN;
    const Blockers blockers = blockers_of(of, in);
    const u32 n = in->node.n_spheres;

    ANSWERS(asks_all, n, "each sphere of the leaf was asked, though one in the way is enough");
    EACH(uncounted, IS_FOUND(0) && is_any_blocked(answers),
         "leaves block, but no call is counted: intersect_sphere counts, if `work` is passed on to "
         "it");
    EACH(unasked, IS_FOUND(0) && !is_any_blocked(answers),
         "no leaf blocks, and no sphere was asked: from where to where does the loop run?");
    ANSWERS(only_first, n > 0 ? 1 : 0,
            "the loop ends after its first sphere: where that is not in the way, the next one is "
            "asked");
    EACH(one_late, blockers.is_unsure || IS_FOUND(blockers.first + 2 < n ? blockers.first + 2 : n),
         "one sphere more was asked after the one in the way: the search ends at once");
    ONLY(wrong_too, (found.is_blocked != 0) != (blockers.first < n),
         "the answer is wrong there, too: blocks-before and blocks-edges say more");
    return NO_MORE;
}

static char *describe_early(const void *job, int i, const void *answers)
{
    GIVEN;
    const u32 first = blockers_of(of, in).first, n = in->node.n_spheres;
    const Words which =
        first < n ? words("number %u is in the way", first + 1) : words("none is in the way");
    return message_new("a leaf of %u sphere%s, of which %s: intersect_sphere was called %u time%s, "
                       "expected %u",
                       n, plural(n), which.text, found.n_tests, plural(found.n_tests),
                       first < n ? first + 1 : n);
}

const Function block_early_09 = {"blocks", N_BLOCKS, sizeof(BlockAnswer),
                                 KNOWING(is_early, describe_early, early_known),
                                 .knows_constant = 1};
