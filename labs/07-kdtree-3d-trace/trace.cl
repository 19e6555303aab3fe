// Lab 07: the search through the kd-tree: a ray asks only the spheres of the leaves it meets, in
// the order in which it meets them, and stops at the first hit.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Called by render_kdtree.cl.
#include "choose_children.cl"
#include "clip_to_box.cl"
#include "intersect_sphere.cl"
#include "todo.h"
#include "work.h"

#include "count_sphere_tests.h"

// Ask the spheres of a leaf.
//   node         the leaf
//   sphere_ids   of the whole tree; the leaf's are node.n_spheres from node.first on
//   hit          in: the nearest hit so far; out: the same, or a nearer one; of two at the same
//                distance the sphere with the lower index
// A hit beyond the leaf is kept, too: trace() decides when it counts. Source: lecture, "Leaf
// search".
void search_leaf(KdNode3 node, global const uint *sphere_ids, global const Sphere *spheres, Ray ray,
                 Hit *hit WORK_POINTER)
{
    // TASK search_leaf: as nearest_hit() of lab 05, over the leaf's spheres only. hit->sphere is an
    // index into spheres[], not into sphere_ids[].
    (void)node, (void)sphere_ids, (void)spheres, (void)ray, (void)hit;
    // END search_leaf
}

#include "count_search.h"

// What the ray hits first.
//   spheres                      the scene
//   nodes, sphere_ids, bounds    its kd-tree (kdtree3d.h); node 0 is the root
// Returns what nearest_hit() of lab 05 finds: the distance and the sphere.
// Source: lecture, "Traversal". Static, so that a compiler may put it into the kernel, its only
// caller.
static Hit trace(Ray ray, global const Sphere *spheres, global const KdNode3 *nodes,
                 global const uint *sphere_ids, BBox3D bounds WORK_POINTER)
{
    Hit hit = {INFINITY, NO_SPHERE};
    // The part of the ray inside the node at hand: at first inside the scene's box.
    float t_min = ray.t_min;
    float t_max = ray.t_max;
    if (!clip_to_box(bounds, ray, &t_min, &t_max)) {
        return hit;
    }
    // What every inner node asks of the ray, one entry an axis: a division here saves one a node.
    const float origins[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float inverses[3] = {1.0f / ray.direction.x, 1.0f / ray.direction.y,
                               1.0f / ray.direction.z};
    Todo todo;
    todo.n = 0;
    // TASK trace: from the root down. An inner node: go on with the near child, the far child or
    // both: then the far one waits on the stack, each with its own part of the ray. A leaf: search
    // it; a hit before the end of the leaf's part of the ray ends everything, else the next node
    // comes from the stack, and an empty stack ends the search, too.
    (void)spheres, (void)nodes, (void)sphere_ids, (void)origins, (void)inverses, (void)todo;
    // END trace
    return hit;
}

#ifdef COUNT_WORK
#define trace(ray, spheres, nodes, sphere_ids, bounds)                                             \
    trace(ray, spheres, nodes, sphere_ids, bounds, work)
#endif
