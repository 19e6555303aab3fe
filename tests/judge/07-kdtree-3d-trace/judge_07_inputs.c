// Rolling the inputs of lab 07's functions. In every range some inputs are plain, so that an answer
// that is always the same is wrong in all of them.
#include "judge_07.h"

#include "random3d.h"

#include <math.h>

static Vec3 unit_vector(Random *random)
{
    Vec3 v;
    do {
        v = random_point(random, 1);
    } while (vec3_dot(v, v) < 0.25f || fabsf(v.x) < 0.03125f || fabsf(v.y) < 0.03125f ||
             fabsf(v.z) < 0.03125f);
    return vec3_normalized(v);
}

static float *axis_of(Vec3 *v, int axis)
{
    return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

// ---- clip_to_box ------------------------------------------------------------------------------

// Coordinates in sixteenths.
static BBox3D roll_box(Random *random)
{
    BBox3D box;
    for (int axis = 0; axis < 3; axis++) {
        box.min[axis] = random_grid(random, -4, 2);
        box.max[axis] = box.min[axis] + 0.5f + random_grid(random, 0, 4);
    }
    return box;
}

// A point in the box made `scale` times as large.
static Vec3 roll_point(Random *random, const BBox3D *box, double scale)
{
    Vec3 p;
    for (int axis = 0; axis < 3; axis++) {
        const double middle = (box->min[axis] + box->max[axis]) / 2;
        const double half = scale * (box->max[axis] - box->min[axis]) / 2;
        *axis_of(&p, axis) = random_number(random, middle - half, middle + half);
    }
    return p;
}

static int holds(const BBox3D *box, Vec3 p)
{
    for (int axis = 0; axis < 3; axis++) {
        const float coordinate = *axis_of(&p, axis);
        if (coordinate < box->min[axis] || coordinate > box->max[axis]) {
            return 0;
        }
    }
    return 1;
}

// A ray from outside towards the box, or past it.
static ClipJob roll_towards(Random *random)
{
    ClipJob job = {.box = roll_box(random), .t_max = INFINITY};
    Vec3 way;
    do {
        job.origin = random_point(random, 10);
        way = vec3_minus(roll_point(random, &job.box, 1.5), job.origin);
    } while (holds(&job.box, job.origin) || vec3_dot(way, way) < 0.25f || way.x == 0 ||
             way.y == 0 || way.z == 0);
    job.direction = vec3_normalized(way);
    return job;
}

// Exactly along an axis, with whole numbers of sixteenths all over: what remains may be one point.
static ClipJob roll_point_left(Random *random)
{
    ClipJob job = {.box = roll_box(random), .t_max = INFINITY};
    const int axis = (int)random_integer(random, 0, 2);
    const int is_up = one_in(random, 2);
    for (int other = 0; other < 3; other++) {
        // Between the planes, or on one of them.
        *axis_of(&job.origin, other) =
            one_in(random, 2) ? job.box.min[other] + 0.25f
                              : (one_in(random, 2) ? job.box.min[other] : job.box.max[other]);
    }
    *axis_of(&job.direction, axis) = is_up ? 1 : -1;
    float *origin = axis_of(&job.origin, axis);
    switch (random_integer(random, 0, 2)) {
    case 0:  // the eye is on the box's far side and looks away
        *origin = is_up ? job.box.max[axis] : job.box.min[axis];
        break;
    case 1:  // the part ends where the box begins
        *origin = is_up ? job.box.min[axis] - 2 : job.box.max[axis] + 2;
        job.t_max = 2;
        break;
    default:  // it begins where the box ends
        *origin = is_up ? job.box.max[axis] - 0.25f : job.box.min[axis] + 0.25f;
        job.t_min = 0.25f;
        job.t_max = 8;
    }
    return job;
}

static ClipJob roll_clip(Random *random, enum ClipRange range)
{
    ClipJob job = roll_towards(random);
    if (range == CLIP_FROM_OUTSIDE || one_in(random, 4)) {
        return job;
    }
    if (range == CLIP_PART) {
        // From inside, and parts that begin or end there.
        if (!one_in(random, 4)) {
            job.origin = roll_point(random, &job.box, 0.9375);
            job.direction = unit_vector(random);
        }
        if (!one_in(random, 3)) {
            job.t_min = random_number(random, 0, 1);
            job.t_max = job.t_min + random_number(random, 0.125, 2);
        }
    } else if (range == CLIP_BESIDE) {
        const float distance =
            (float)vec3_length(vec3_minus(roll_point(random, &job.box, 0), job.origin));
        switch (random_integer(random, 0, 2)) {
        case 0:  // behind the eye
            job.direction = vec3_scaled(job.direction, -1);
            break;
        case 1:  // beyond the part that counts
            job.t_max = distance / 8;
            break;
        default:  // before it
            job.t_min = distance * 4;
        }
    } else if (one_in(random, 3)) {
        return roll_point_left(random);
    } else {
        // Along the planes of one axis or two: aimed at the box it is hit, else mostly not.
        job.origin = one_in(random, 2) ? job.origin : roll_point(random, &job.box, 1.5);
        const int first = (int)random_integer(random, 0, 2);
        for (int i = 0; i < (one_in(random, 2) ? 1 : 2); i++) {
            const int axis = (first + i) % 3;
            *axis_of(&job.direction, axis) = one_in(random, 2) ? 0.0f : -0.0f;
            if (!one_in(random, 4)) {
                *axis_of(&job.origin, axis) = one_in(random, 4)
                                                  ? job.box.min[axis]
                                                  : (job.box.min[axis] + job.box.max[axis]) / 2;
            }
        }
        job.direction = vec3_normalized(job.direction);
    }
    return job;
}

// ---- near_side, children_on_ray ---------------------------------------------------------------

static KdNode3 roll_node(Random *random, float split_pos)
{
    const u32 split_axis = (u32)random_integer(random, 0, 2);
    const u32 first = (u32)random_integer(random, 1, 100);
    return (KdNode3){split_pos, split_axis, first, 0};
}

static float roll_sign(Random *random)
{
    return one_in(random, 2) ? 1.0f : -1.0f;
}

// A number of this size with any sign. C leaves open which side of a product is rolled first.
static float roll_signed(Random *random, double lowest, double highest)
{
    const float sign = roll_sign(random);
    return sign * random_number(random, lowest, highest);
}

static SideJob roll_side(Random *random, int is_on_plane)
{
    const float split_pos = random_number(random, -4, 4);
    SideJob job = {roll_node(random, split_pos), split_pos, 0};
    // 1 / direction: infinite if the ray is along the plane. 0 shall do no harm either.
    switch (random_integer(random, 0, 5)) {
    case 0:
        job.inverse = roll_sign(random);
        job.inverse *= one_in(random, 2) ? 0 : INFINITY;
        break;
    case 1:
        job.inverse = roll_signed(random, 2, 100);
        break;
    default:
        job.inverse = roll_signed(random, 0.03125, 1);
    }
    if (!is_on_plane) {
        const float sign = roll_sign(random);
        // Beside the plane, and as near to it as float can be.
        job.origin = one_in(random, 4) ? nextafterf(split_pos, sign * INFINITY)
                                       : split_pos + sign * random_number(random, 0.0625, 4);
    }
    return job;
}

static PlaneJob roll_plane(Random *random, enum PlaneRange range)
{
    PlaneJob job = {.origin = random_number(random, -4, 4)};
    float direction = roll_signed(random, 0.0625, 1);
    job.t_min = one_in(random, 4) ? 0 : random_number(random, 0.5, 4);
    job.t_max = job.t_min + random_number(random, 0.5, 4);
    // Before the part, in it, beyond it.
    const float before = random_number(random, 0.125, 0.875) * job.t_min;
    const float inside = job.t_min + random_number(random, 0.125, 0.875) * (job.t_max - job.t_min);
    const float beyond = job.t_max + random_number(random, 0.25, 4);
    const float ahead[] = {before, inside, beyond};
    float t = ahead[random_integer(random, job.t_min > 0 ? 0 : 1, 2)];
    if (range == PLANES_AHEAD && one_in(random, 6)) {
        // Exactly at an end of the part. Nothing is rounded: all is on the grid, 1 / 4 of it, or
        // a power of two.
        direction = roll_sign(random) * 0.25f;
        t = job.t_min > 0 && one_in(random, 2) ? job.t_min : job.t_max;
    }
    if (range == PLANES_BEHIND && !one_in(random, 4)) {
        t = one_in(random, 3) ? 0 : -random_number(random, 0.125, 6);
        // The eye on the plane is in the node, or the node is ahead of it. Times a power of two
        // nothing is rounded, whether the compiler fuses a product with a difference or not.
        job.t_min = one_in(random, 2) ? 0 : job.t_min;
        direction = t == 0 ? roll_sign(random) * 0.25f : direction;
    }
    job.inverse = 1 / direction;
    job.node = roll_node(random, job.origin + t * direction);
    if (range == PLANES_ALONG && !one_in(random, 4)) {
        job.inverse = roll_sign(random) * INFINITY;
        job.node.split_pos = one_in(random, 2) ? job.origin : random_number(random, -4, 4);
    }
    return job;
}

// ---- search_leaf ------------------------------------------------------------------------------

// The spheres: first some of different places, then copies of as many, then the one that must not
// be asked in each leaf, and others up to the end of the array.
enum { N_PLACES = 48, N_COPIES = 24, FIRST_GUARD = N_PLACES + N_COPIES };

static void roll_leaf_spheres(Random *random, Sphere *spheres)
{
    for (int i = 0; i < N_SHORT_LEAF_IDS; i++) {
        const Vec3 centre = random_point(random, 1);
        spheres[i] = (Sphere){centre.x, centre.y, centre.z, random_number(random, 0.125, 0.5)};
        spheres[i].radius *= one_in(random, 6) ? -1 : 1;
    }
    for (int i = 0; i < N_COPIES; i++) {
        spheres[N_PLACES + i] = spheres[i];
    }
}

// Write a leaf's ids, ascending, and a guard before and behind them. Returns how many there are, at
// most n_wanted.
static u32 roll_leaf_ids(Random *random, int n_wanted, int has_copies, u32 guard, u32 *ids)
{
    const int n_all = has_copies ? N_PLACES + N_COPIES : N_PLACES;
    u32 n_ids = 0;
    ids[0] = guard;
    for (int id = 0; id < n_all && n_ids < (u32)n_wanted; id++) {
        if (one_in(random, n_all / (n_wanted + 1))) {
            ids[++n_ids] = (u32)id;
        }
    }
    ids[n_ids + 1] = guard;
    return n_ids;
}

// Aim at a sphere's middle along an axis, and let the hit so far be just as far away. So far off
// that a root which is a little wrong rounds to the right distance: what is equal in double is
// equal in float.
static void roll_tie(Random *random, Sphere sphere, SearchJob *job)
{
    const int axis = (int)random_integer(random, 0, 2);
    const float distance = 1024, way = one_in(random, 2) ? 1 : -1;
    job->origin = (Vec3){sphere.x, sphere.y, sphere.z};
    *axis_of(&job->origin, axis) -= way * distance;
    job->direction = (Vec3){0, 0, 0};
    *axis_of(&job->direction, axis) = way;
    job->t = distance - sphere.radius;
    job->sphere = (u32)random_integer(random, 0, N_PLACES + N_COPIES - 1);
}

static SearchJob roll_leaf(Random *random, Inputs07 *inputs, int i)
{
    const u32 guard = FIRST_GUARD + (u32)i;
    const u32 first = (u32)i * (LEAF_MAX_SPHERES + 2);
    u32 *ids = inputs->leaf_ids + first;
    // The first leaf is full. Its range begins near 0: who takes n_spheres for the end asks some.
    const int n_wanted =
        i == 0 ? LEAF_MAX_SPHERES : (int)random_integer(random, 0, LEAF_MAX_SPHERES);
    const u32 n_ids = roll_leaf_ids(random, n_wanted, i >= N_LEAF_INPUTS, guard, ids);
    SearchJob job = {.node = {.split_axis = KD_LEAF, .first = first + 1, .n_spheres = n_ids},
                     .t = INFINITY,
                     .sphere = ORACLE_NO_SPHERE};
    // Outside the spheres or among them, and towards one of the leaf's.
    const float distance = random_number(random, 0.25, 4);
    job.origin = vec3_scaled(unit_vector(random), distance);
    const u32 target =
        n_ids > 0 ? ids[random_integer(random, 1, n_ids)] : (u32)random_integer(random, 0, 9);
    const Sphere sphere = inputs->leaf_spheres[target];
    const Vec3 way = vec3_minus((Vec3){sphere.x, sphere.y, sphere.z}, job.origin);
    job.direction = vec3_dot(way, way) < 0.0625f ? unit_vector(random) : vec3_normalized(way);
    if (one_in(random, 2)) {
        job.t = random_number(random, 0.25, 5);
        job.sphere = (u32)random_integer(random, FIRST_GUARD + N_LEAVES, N_SHORT_LEAF_IDS - 1);
    }
    if (i >= N_LEAF_INPUTS && i % 4 == 0) {
        roll_tie(random, sphere, &job);
    }
    // Around the eye: nearer than all.
    inputs->leaf_spheres[guard] = (Sphere){job.origin.x, job.origin.y, job.origin.z, GUARD_RADIUS};
    return job;
}

// ---- All --------------------------------------------------------------------------------------

void roll_inputs_07(Random *random, Inputs07 *inputs)
{
    for (int i = 0; i < COUNT(inputs->clips); i++) {
        inputs->clips[i] = roll_clip(random, (enum ClipRange)(i / N_CLIP_INPUTS));
    }
    for (int i = 0; i < COUNT(inputs->sides); i++) {
        inputs->sides[i] = roll_side(random, i >= N_SIDE_INPUTS && !one_in(random, 4));
    }
    for (int i = 0; i < COUNT(inputs->planes); i++) {
        inputs->planes[i] = roll_plane(random, (enum PlaneRange)(i / N_PLANE_INPUTS));
    }
    roll_leaf_spheres(random, inputs->leaf_spheres);
    for (int i = 0; i < N_LEAVES; i++) {
        inputs->leaves[i] = roll_leaf(random, inputs, i);
    }
    roll_child_inputs_07(random, inputs);
    roll_waiting_inputs_07(random, inputs);
    inputs_07_set_edges(inputs);
}
