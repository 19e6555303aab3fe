// Lab 09: which lights reach a point? A shadow ray goes to each light. Any hit before the light
// blocks it, so the search need not find the nearest hit.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by mirrors.cl.
#include "shade.cl"
#include "trace.cl"
#include "traced_scene.h"

// The ray from a point to a light. It ends there: a ball behind the light casts no shadow.
//   point   off the surface already (leave_surface())
// Returns a ray whose direction is a unit vector, t_min 0 and t_max the light's distance.
Ray shadow_ray(float3 point, Light light)
{
    Ray ray = {point, (float3)(0.0f, 0.0f, 1.0f), 0.0f, 0.0f};
    // TASK shadow_ray: the direction to the light, and how far it is.
    (void)light;
    // END shadow_ray
    return ray;
}

// Does a sphere of this leaf block the ray before its end?
//   node         the leaf
//   sphere_ids   of the whole tree; the leaf's are node.n_spheres from node.first on
//   work         what this pixel has cost so far: for intersect_sphere()
// Returns 1, or 0 when no sphere of it does.
int leaf_blocks(KdNode3 node, global const uint *sphere_ids, global const Sphere *spheres, Ray ray,
                Work *work)
{
    // TASK leaf_blocks: as search_leaf() of lab 07, but any hit before ray.t_max will do: the first
    // one that is found ends the search.
    (void)node, (void)sphere_ids, (void)spheres, (void)ray, (void)work;
    // END leaf_blocks
    return 0;
}

// Is the ray blocked? trace() of lab 07 with another end: it stops at any hit, not only at one that
// is certainly the nearest. Nothing to fill in here.
//   work   what this pixel has cost so far
static int is_blocked(Ray ray, const TracedScene *scene, Work *work)
{
#ifdef NO_SHADOWS  // key L of the window draws without: all light arrives
    return 0;
#endif
    // The node at hand, and the part of the ray inside it.
    TodoEntry at = {0, ray.t_min, ray.t_max};
    if (!clip_to_box(scene->bounds, ray, &at.t_min, &at.t_max)) {
        return 0;
    }
    const float origins[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float inverses[3] = {1.0f / ray.direction.x, 1.0f / ray.direction.y,
                               1.0f / ray.direction.z};
    Todo todo;
    todo.n = 0;
    for (;;) {
        const KdNode3 node = scene->nodes[at.node];
        if (node.split_axis != KD_LEAF) {
            count_node(work);
            at = next_child(node, origins[node.split_axis], inverses[node.split_axis], at.t_min,
                            at.t_max, &todo);
            count_waiting(work, todo.n);
            continue;
        }
        count_leaf(work);
        if (leaf_blocks(node, scene->sphere_ids, scene->spheres, ray, work)) {
            return 1;
        }
        if (todo.n == 0) {
            return 0;
        }
        at = todo_pop(&todo);
    }
}

// Lambert's law as in lab 05, without the lights that do not reach the point.
//   point, normal   off the surface already; unit vector
//   work            what this pixel has cost so far
// Returns red, green and blue.
float3 lit_color(float3 point, float3 normal, Material material, const TracedScene *scene,
                 Work *work)
{
    float3 color = (float3)(0.0f);
    // TASK lit_color: for each light in front of the surface: is anything between? If not, add what
    // shade() of lab 05 makes of this one light.
    (void)point, (void)normal, (void)material, (void)scene, (void)work;
    // END lit_color
    return color;
}
