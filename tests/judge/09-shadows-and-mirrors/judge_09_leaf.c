// Lab 09: is anything of a leaf in the way of a ray? Drawn and judged, with how many were asked.
#include "judge_09.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

static const OracleRules3D right = {0};

// ---- Drawing ------------------------------------------------------------------------------------

// Where a sphere is to the ray. Only the last three are in its way.
typedef enum Place {
    BEHIND_END,
    BESIDE,
    BEHIND_START,
    AROUND_ALL,    // the ray starts and ends inside
    FAR_SIDE_OUT,  // of a negative radius: the side that is there is behind the end
    BEFORE_END,
    AROUND_START,  // the ray leaves it before its end
    ACROSS_END,    // the ray ends inside
} Place;
enum { N_FREE_PLACES = BEFORE_END, N_PLACES = ACROSS_END + 1 };

typedef struct Frame {
    Vec3 origin, direction, across;  // unit vectors
    float t_max;
} Frame;

// A sphere whose middle is `along` the ray and `aside` of it.
static Sphere sphere_at(const Frame *frame, float along, float aside, float radius)
{
    const Vec3 o = frame->origin, d = frame->direction, a = frame->across;
    return (Sphere){o.x + along * d.x + aside * a.x, o.y + along * d.y + aside * a.y,
                    o.z + along * d.z + aside * a.z, radius};
}

static Sphere draw_sphere(Random *random, const Frame *frame, Place place)
{
    const float end = frame->t_max;
    const float radius = end * random_number(random, 0.0625, 0.1875);
    const float share = random_number(random, 0.0625, 0.75);
    const float aside = radius * random_number(random, 0, 0.75);
    switch (place) {
    case BEHIND_END:
        return sphere_at(frame, end * (1 + share) + radius, aside, radius);
    case BESIDE:
        return sphere_at(frame, end * share, radius * random_number(random, 1.125, 2), radius);
    case BEHIND_START:
        return sphere_at(frame, -end * share - radius, aside, radius);
    case AROUND_ALL:
        return sphere_at(frame, end / 2, aside, end * (1 + share));
    case FAR_SIDE_OUT:
        return sphere_at(frame, end, aside, -radius);
    case AROUND_START:
        return sphere_at(frame, 0, aside, end * random_number(random, 0.25, 0.75));
    case ACROSS_END:
        return sphere_at(frame, end, aside, radius);
    default:
        return sphere_at(frame, end * share + radius / 4, aside, radius);
    }
}

// Not much more than float may be off with where a ray meets a sphere.
#define LEAST_HAIR 0x1p-16f

// On the ray, met a hair behind its start, before its end or behind its end.
static Sphere draw_edge(Random *random, const Frame *frame)
{
    const float hair = frame->t_max * (random_integer(random, 0, 1) ? HAIR : LEAST_HAIR);
    const float radius = frame->t_max * random_number(random, 0.125, 0.25);
    const int kind = (int)random_integer(random, 0, 2);
    const float t = kind == 0 ? hair : frame->t_max + (kind == 1 ? -hair : hair);
    return sphere_at(frame, t + radius, 0, radius);
}

static Frame draw_frame(Random *random, int range)
{
    Frame frame = {.direction = random_direction(random)};
    frame.t_max = random_number(random, 2, 8);
    if (range == 1) {
        frame.t_max *= ldexpf(1, (int)random_integer(random, -20, 20));
    }
    frame.origin = vec3_scaled(random_point(random, 1), frame.t_max / 4);
    do {
        frame.across = vec3_cross(frame.direction, random_direction(random));
    } while (vec3_dot(frame.across, frame.across) < 0.125f);
    frame.across = vec3_normalized(frame.across);
    return frame;
}

// A leaf of up to BLOCK_MAX_SPHERES spheres, of which none, one or two are in the way, and one
// before and behind it that must not be asked. Its ids stand in no order.
static void draw_block(Random *random, int i, Job09 *job)
{
    const int range = i / N_BLOCK_INPUTS;
    const Frame frame = draw_frame(random, range);
    const u32 n = i % 16 == 0 ? 0 : (u32)random_integer(random, 1, BLOCK_MAX_SPHERES);
    const u32 before = (u32)i * (BLOCK_MAX_SPHERES + 2);
    const u32 end = before + 1 + n, room = BLOCK_MAX_SPHERES + 2;
    const u32 n_blockers = (u32)random_integer(random, 0, 2);
    job->blocks[i] =
        (BlockJob){{0, KD_LEAF, before + 1, n}, frame.origin, frame.direction, frame.t_max};
    for (u32 k = 0; k < room; k++) {
        const u32 at = before + k, id = before + (k * 7 + 3) % room;
        const int is_guard = at == before || at == end;
        const int is_blocker = (k * 5 + (u32)i) % (n + 1) < n_blockers;
        const Place place = is_guard     ? BEFORE_END
                            : is_blocker ? (Place)random_integer(random, BEFORE_END, N_PLACES - 1)
                                         : (Place)random_integer(random, 0, N_FREE_PLACES - 1);
        job->block_ids[at] = id;
        job->block_spheres[id] = range == 1 && is_blocker && !is_guard
                                     ? draw_edge(random, &frame)
                                     : draw_sphere(random, &frame, place);
    }
}

// A leaf behind the others in the list of ids; only its last sphere is in the way.
static void draw_long_leaf(Random *random, Job09 *job)
{
    const Frame frame = draw_frame(random, 0);
    const u32 before = FIRST_LONG_ID, end = before + N_LONG_LEAF + 1;
    for (u32 at = N_SHORT_BLOCK_IDS; at < before; at++) {
        job->block_ids[at] = N_SHORT_BLOCK_IDS;
    }
    job->blocks[LONG_LEAF] = (BlockJob){
        {0, KD_LEAF, before + 1, N_LONG_LEAF}, frame.origin, frame.direction, frame.t_max};
    for (u32 at = before; at <= end; at++) {
        const u32 id = before + end - at;
        const Place place = at == before || at + 1 >= end
                                ? BEFORE_END
                                : (Place)random_integer(random, 0, N_FREE_PLACES - 1);
        job->block_ids[at] = id;
        job->block_spheres[id] = draw_sphere(random, &frame, place);
    }
}

// A ray along an axis through the middle of a sphere, whose near side is where the ray ends, or the
// least before that. All numbers are whole: what is rounded, the sphere's root, is too little to
// show so far away.
static void set_end(Job09 *job, int k)
{
    const int i = N_BLOCKS - N_BLOCK_ENDS + k, axis = k % 3, is_before = k >= N_BLOCK_ENDS / 2;
    const float t = 64, way = k % 2 == 0 ? 1 : -1;
    const Vec3 direction = {axis == 0 ? way : 0, axis == 1 ? way : 0, axis == 2 ? way : 0};
    const u32 before = (u32)i * (BLOCK_MAX_SPHERES + 2);
    for (u32 at = before; at < before + 3; at++) {
        const Vec3 centre = vec3_scaled(direction, at == before + 1 ? t + 1 : t / 2);
        const u32 id = 2 * before + 2 - at;
        job->block_ids[at] = id;
        job->block_spheres[id] = (Sphere){centre.x, centre.y, centre.z, 1};
    }
    job->blocks[i] = (BlockJob){
        {0, KD_LEAF, before + 1, 1}, {0, 0, 0}, direction, is_before ? nextafterf(t, INFINITY) : t};
}

// Is it one of these, or one that is as exact?
static int is_exact(const BlockJob *in)
{
    const Vec3 d = in->direction;
    return (d.x == 0) + (d.y == 0) + (d.z == 0) == 2;
}

void blocks_09_draw(Random *random, Job09 *job)
{
    for (int i = 0; i < N_BLOCKS; i++) {
        draw_block(random, i, job);
    }
    draw_long_leaf(random, job);
    for (int k = 0; k < N_BLOCK_ENDS; k++) {
        set_end(job, k);
    }
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
    int at_end;          // a hit at t_max itself counts
    int misses_long;     // the longest leaf blocks nothing
    double start, end;   // hits so near to them, as a share of t_max, do not count
} BlockMistake;

static const BlockMistake mistakes[] = {
    {.cause = {0}},
    {{.says = "a hit behind the ray's end blocks nothing: t_max"}, .any_distance = 1},
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
    {{.says = "hits very near to the start of the ray count, too, without an epsilon"},
     .start = 1.5 * HAIR},
    {{.says = "hits very near to the end of the ray count, too, without an epsilon"},
     .end = 1.5 * HAIR},
    {{.says = "hits very near to the start of the ray count, too, without an epsilon"},
     .start = 1.5 * LEAST_HAIR},
    {{.says = "hits very near to the end of the ray count, too, without an epsilon"},
     .end = 1.5 * LEAST_HAIR},
};

static OracleRay ray_of(const BlockJob *in)
{
    return oracle3d_given_ray(in->origin, in->direction, 0);
}

// Does the sphere in place `at` of the ids block, by a mistake's rules?
static Blocks sphere_blocks(const Job09 *job, const BlockJob *in, u32 at,
                            const BlockMistake *mistake)
{
    const OracleRay ray = ray_of(in);
    const u32 id = mistake->is_position ? at : job->block_ids[at];
    const OracleRoot root = oracle3d_root(job->block_spheres[id], &ray, ORACLE_PROJECTION, &right);
    if (mistake->miss_blocks && !root.is_possible) {
        return YES;
    }
    if (mistake->behind_end) {
        return root.is_certain && root.t_low > in->t_max ? YES : NO;
    }
    const double start = mistake->start * in->t_max;
    const double end = mistake->any_distance ? INFINITY : in->t_max * (1 - mistake->end);
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
    const u32 n = mistake->misses_long && i == LONG_LEAF ? 0 : in->node.n_spheres;
    const u32 start = mistake->from_start ? 0 : in->node.first;
    const u32 skipped = mistake->skips_first ? 1 : mistake->last_decides && n > 0 ? n - 1 : 0;
    const u32 end = mistake->first_only && n > 1 ? 1 : n + (mistake->one_more ? 1 : 0);
    Blocks any = NO, all = end > skipped ? YES : NO;
    for (u32 k = skipped; k < end; k++) {
        const Blocks own = sphere_blocks(job, in, start + k, mistake);
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

const Function block_09 = {"blocks",
                           N_BLOCKS,
                           sizeof(BlockAnswer),
                           .describe = describe_block,
                           .agrees = block_agrees,
                           .counted = "inputs",
                           MISTAKES(mistakes)};

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

// In either order: each up to the one that is found first.
static int early_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const Job09 *job = pointer;
    const u32 n = job->blocks[i].node.n_spheres;
    const u32 found = ((const BlockAnswer *)answers)[i].n_tests;
    const Blockers blockers = blockers_of(job, i);
    if (mistake == 1) {
        return found == n;
    }
    if (blockers.is_unsure || blockers.first == n) {
        return blockers.is_unsure || found == n;
    }
    return found == blockers.first + 1 || found == n - blockers.last;
}

static const Cause early_causes[] = {
    {0},
    {.says = "each sphere of the leaf was asked, though one in the way is enough"},
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

const Function block_early_09 = {"blocks",
                                 N_BLOCKS,
                                 sizeof(BlockAnswer),
                                 .describe = describe_early,
                                 .agrees = early_agrees,
                                 .counted = "inputs",
                                 MISTAKES(early_causes)};
