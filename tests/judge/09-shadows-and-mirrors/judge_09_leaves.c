// Lab 09: leaves and rays, rolled for leaf_blocks. See judge_09.h; judge_09_leaf.c judges.
#include "judge_09.h"

#include "random3d.h"

#include <math.h>

// Where a sphere is to the ray. Only the last four are in its way.
typedef enum Place {
    BEHIND_END,
    BESIDE,
    BEHIND_START,
    AROUND_ALL,    // the ray starts and ends inside
    FAR_SIDE_OUT,  // of a negative radius: the side that is there is behind the end
    BEFORE_END,
    AROUND_START,  // the ray leaves it before its end
    AROUND_START_NEGATIVE,
    ACROSS_END,  // the ray ends inside
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

static Sphere roll_sphere(Random *random, const Frame *frame, Place place)
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
    case AROUND_START_NEGATIVE:
        return sphere_at(frame, 0, aside, -end * random_number(random, 0.25, 0.75));
    case ACROSS_END:
        return sphere_at(frame, end, aside, radius);
    default:
        return sphere_at(frame, end * share + radius / 4, aside, radius);
    }
}

// On the ray, met a hair behind its start, before its end or behind its end.
static Sphere roll_edge(Random *random, const Frame *frame)
{
    const float hair = frame->t_max * (random_integer(random, 0, 1) ? HAIR : LEAST_HAIR);
    const float radius = frame->t_max * random_number(random, 0.125, 0.25);
    const int kind = (int)random_integer(random, 0, 2);
    const float t = kind == 0 ? hair : frame->t_max + (kind == 1 ? -hair : hair);
    return sphere_at(frame, t + radius, 0, radius);
}

static Frame roll_frame(Random *random, int range)
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
static void roll_block(Random *random, int i, Job09 *job)
{
    const int range = i / N_BLOCK_INPUTS;
    const Frame frame = roll_frame(random, range);
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
                                     ? roll_edge(random, &frame)
                                     : roll_sphere(random, &frame, place);
    }
}

// A leaf behind the others in the list of ids; only its last sphere is in the way.
static void roll_long_leaf(Random *random, Job09 *job)
{
    const Frame frame = roll_frame(random, 0);
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
        job->block_spheres[id] = roll_sphere(random, &frame, place);
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

void roll_blocks_09(Random *random, Job09 *job)
{
    for (int i = 0; i < N_BLOCKS; i++) {
        roll_block(random, i, job);
    }
    roll_long_leaf(random, job);
    for (int k = 0; k < N_BLOCK_ENDS; k++) {
        set_end(job, k);
    }
}
