// Inputs of lab 07's functions that the search sends for whole pictures: see judge_07.h, sent.h.
//
// Some rays are followed from the root to one of their leaves, as double has it: where both
// children are met, into either one.
#include "judge_07.h"
#include "random3d.h"
#include "sent.h"

#include <math.h>

// Where the inputs go.
typedef struct SentInputs {
    Inputs07 *inputs;
    Sent clips[N_CLIP_RANGES], sides[2], planes[N_PLANE_RANGES];
    int n_leaves;
} SentInputs;

// A ray as the search has it, and the part that is in the node.
typedef struct Followed {
    Vec3 origin, direction;
    double t_min, t_max;
} Followed;

static float part_of(Vec3 v, u32 axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// ---- clip_to_box --------------------------------------------------------------------------------

// The call for a scene's box; narrows the ray to it.
static void keep_clip(Random *random, BBox3D box, Followed *ray, SentInputs *sent)
{
    const ClipJob job = {box, ray->origin, ray->direction, 0, INFINITY};
    int is_along = 0, is_outside = 0;
    for (u32 axis = 0; axis < 3; axis++) {
        const double origin = part_of(ray->origin, axis), way = part_of(ray->direction, axis);
        const double low = (box.min[axis] - origin) / way, high = (box.max[axis] - origin) / way;
        is_along |= way == 0;
        is_outside |= origin < box.min[axis] || origin > box.max[axis];
        if (way != 0) {
            ray->t_min = fmax(ray->t_min, fmin(low, high));
            ray->t_max = fmin(ray->t_max, fmax(low, high));
        }
    }
    const enum ClipRange range = is_along ? CLIP_ALONG : is_outside ? CLIP_FROM_OUTSIDE : CLIP_PART;
    sent_keep(&sent->clips[range], random, &job);
}

// ---- near_side, children_on_ray -----------------------------------------------------------------

// The calls for an inner node; narrows the ray to one of the children that it meets. Returns that.
static u32 keep_node(Random *random, KdNode3 node, Followed *ray, SentInputs *sent)
{
    const float origin = part_of(ray->origin, node.split_axis);
    const float inverse = 1 / part_of(ray->direction, node.split_axis);
    const SideJob side = {node, origin, inverse};
    const PlaneJob plane = {node, origin, inverse, (float)ray->t_min, (float)ray->t_max};
    const double t = ((double)node.split_pos - origin) * inverse;
    const enum PlaneRange range = isinf(inverse) ? PLANES_ALONG
                                  : t > 0        ? PLANES_AHEAD
                                                 : PLANES_BEHIND;
    sent_keep(&sent->sides[origin == node.split_pos], random, &side);
    sent_keep(&sent->planes[range], random, &plane);
    const u32 near_child =
        node.first + (origin == node.split_pos ? inverse > 0 : origin > node.split_pos);
    const u32 far_child = 2 * node.first + 1 - near_child;
    if (!(t > 0 && t <= ray->t_max)) {
        return near_child;
    }
    if (t >= ray->t_min && one_in(random, 2)) {
        ray->t_max = t;
        return near_child;
    }
    ray->t_min = fmax(t, ray->t_min);
    return far_child;
}

// ---- search_leaf --------------------------------------------------------------------------------

// The call for a leaf, as number `i`, with spheres of its own. Long leaves are left out.
static void keep_leaf(Random *random, const JobScene3D *scene, KdNode3 leaf, const Followed *ray,
                      SentInputs *sent)
{
    if (leaf.n_spheres == 0 || leaf.n_spheres > LEAF_MAX_SPHERES ||
        sent->n_leaves == N_SENT_LEAVES) {
        return;
    }
    Inputs07 *inputs = sent->inputs;
    const u32 i = 1 + (u32)sent->n_leaves++;  // the first leaf is another one in every job
    SearchJob *job = &inputs->leaves[i];
    const u32 first = i * (LEAF_MAX_SPHERES + 2) + 1, guard = inputs->leaf_ids[first - 1];
    for (u32 k = 0; k < leaf.n_spheres; k++) {
        const u32 id = N_SHORT_LEAF_IDS + i * LEAF_MAX_SPHERES + k;
        inputs->leaf_ids[first + k] = id;
        inputs->leaf_spheres[id] = scene->scene.spheres[scene->tree.sphere_ids[leaf.first + k]];
    }
    inputs->leaf_ids[first + leaf.n_spheres] = guard;
    inputs->leaf_spheres[guard] =
        (Sphere){ray->origin.x, ray->origin.y, ray->origin.z, GUARD_RADIUS};
    const int has_hit = one_in(random, 2);
    *job = (SearchJob){.node = {.split_axis = KD_LEAF, .first = first, .n_spheres = leaf.n_spheres},
                       .origin = ray->origin,
                       .direction = ray->direction,
                       .t = has_hit ? (float)ray->t_max : INFINITY,
                       .sphere = has_hit ? N_SHORT_LEAF_IDS - 1 : ORACLE_NO_SPHERE};
}

// ---- All ----------------------------------------------------------------------------------------

static void follow(Random *random, const JobScene3D *scene, SentInputs *sent)
{
    const int n_pixels = scene->scene.width * scene->scene.height;
    const OracleRay ray = job_scene3d_ray(scene, (int)random_integer(random, 0, n_pixels - 1));
    Followed followed = {vector_rounded(ray.origin), vector_rounded(ray.direction), 0, INFINITY};
    keep_clip(random, scene->tree.bounds, &followed, sent);
    KdNode3 node = scene->tree.nodes[0];
    while (node.split_axis != KD_LEAF && followed.t_min <= followed.t_max) {
        node = scene->tree.nodes[keep_node(random, node, &followed, sent)];
    }
    if (followed.t_min <= followed.t_max) {
        keep_leaf(random, scene, node, &followed, sent);
    }
}

void inputs_07_add_sent(Random *random, const JobScene3D scenes[N_SCENES], Inputs07 *inputs)
{
    enum { N_RAYS = 4000 };
    SentInputs sent = {.inputs = inputs};
    for (int range = 0; range < N_CLIP_RANGES; range++) {
        sent.clips[range] = SENT_TO(inputs->clips + range * N_CLIP_INPUTS, N_SENT_CLIPS);
    }
    for (int range = 0; range < 2; range++) {
        sent.sides[range] = SENT_TO(inputs->sides + range * N_SIDE_INPUTS, N_SENT_SIDES);
    }
    for (int range = 0; range < N_PLANE_RANGES; range++) {
        sent.planes[range] = SENT_TO(inputs->planes + range * N_PLANE_INPUTS, N_SENT_PLANES);
    }
    for (int i = 0; i < N_RAYS; i++) {
        follow(random, &scenes[i % N_SCENES], &sent);
    }
}
