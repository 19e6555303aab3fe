// Lab 07: the search through the kd-tree: a ray tests only the spheres of the leaves it meets, in
// the order in which it meets them. It stops as soon as no waiting node can hold a nearer hit.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_kdtree.cl.
#include "choose_children.cl"
#include "clip_to_box.cl"
#include "intersect_sphere.cl"
#include "todo.h"
#include "work.h"

// Test the spheres of a leaf.
//   node         the leaf
//   sphere_ids   of the whole tree; the leaf's are node.n_spheres from node.first on
//   hit          in: the nearest hit so far; out: the same, or a nearer one; at equal distances the
//                sphere with the lower index
//   work         what this pixel has cost so far: for intersect_sphere()
// A hit beyond the leaf is kept, too: next_waiting() decides when it counts.
// Source: lecture, slides "Durchsuche Leaf" and "Berechne SP mit sichtbarem Teilstrahl".
void search_leaf(KdNode3 node, global const uint *sphere_ids, global const Sphere *spheres, Ray ray,
                 Hit *hit, Work *work)
{
    // TASK search_leaf: as nearest_hit() of lab 05, over the leaf's spheres only. hit->sphere is an
    // index into spheres[], not into sphere_ids[].
    //> (void)node, (void)sphere_ids, (void)spheres, (void)ray, (void)hit, (void)work;
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        // The hit so far may be of another leaf, and of a sphere with a higher index.
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
    // END search_leaf
}

// Go on from an inner node: with which child, and does the other one have to wait?
//   node              the inner node
//   origin, inverse   the ray's origin and 1 / direction, along node.split_axis
//   t_min, t_max      the part of the ray inside the node
//   todo              out: if both children are met, the far one is on top
// Returns the child to visit next, with the part of the ray inside it.
// Source: lecture, slides "Bestimme zu durchsuchende Childs" and "Begrenze Strahl für Child".
static TodoEntry next_child(KdNode3 node, float origin, float inverse, float t_min, float t_max,
                            Todo *todo)
{
    // TASK next_child: near_side() and children_on_ray() tell which children the ray meets. If it
    // meets one, go there with the whole part. If it meets both, each gets its own part, up to the
    // plane or from there on: go to the near child, and let the far one wait.
    //> (void)origin, (void)inverse, (void)todo;
    //> return (TodoEntry){node.first, t_min, t_max};
    // node.first + side was measured to be slower on a CPU: the CPU would have to wait for `side`.
    // It guesses the outcome of a choice and reads the next node ahead.
    const uint side = near_side(node, origin, inverse);
    const uint near_child = side ? node.first + 1 : node.first;
    const uint far_child = side ? node.first : node.first + 1;
    float t_split;
    switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return (TodoEntry){near_child, t_min, t_max};
    case ONLY_FAR:
        return (TodoEntry){far_child, t_min, t_max};
    default:
        todo_push(todo, far_child, t_split, t_max);
        return (TodoEntry){near_child, t_min, t_split};
    }
    // END next_child
}

// Go on after a leaf that has been searched, unless the search is over.
//   hit    the nearest hit so far, in this leaf or an earlier one
//   todo   the nodes that wait, the nearest on top
//   at     in: the leaf; out: where the search goes on, which then waits no longer
// Returns 1, or 0 if the search is over. Source: lecture, slide "KD-Tree Raytracing".
static int next_waiting(Hit hit, Todo *todo, TodoEntry *at)
{
    // TASK next_waiting: a hit before the end of the leaf's part of the ray ends the search. An
    // empty stack ends it, too. Otherwise the node on top comes next, with its own part of the ray.
    //> (void)hit, (void)todo, (void)at;
    //> return 0;
    // A hit beyond t_max may be hidden by a sphere that only a later leaf lists. At t_max a later
    // leaf may list a sphere with a lower index that is hit at the same distance.
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
    // END next_waiting
}

// What the ray hits first.
//   spheres                      the scene
//   nodes, sphere_ids, bounds    its kd-tree (kdtree3d.h); node 0 is the root
//   work                         what this pixel has cost so far
// Returns what nearest_hit() of lab 05 finds: the distance and the sphere.
// Source: lecture, slide "KD-Tree Raytracing". Static, so that a compiler may put it into the
// kernel, its only caller.
static Hit trace(Ray ray, global const Sphere *spheres, global const KdNode3 *nodes,
                 global const uint *sphere_ids, BBox3D bounds, Work *work)
{
    Hit hit = {INFINITY, NO_SPHERE};
    // The current node, and the part of the ray inside it: at first the root, and the scene's box.
    TodoEntry at = {0, ray.t_min, ray.t_max};
    if (!clip_to_box(bounds, ray, &at.t_min, &at.t_max)) {
        return hit;
    }
    // What every inner node needs of the ray, by axis: a division here saves one per node.
    const float origins[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float inverses[3] = {1.0f / ray.direction.x, 1.0f / ray.direction.y,
                               1.0f / ray.direction.z};
    Todo todo;
    todo.n = 0;
    for (;;) {
        const KdNode3 node = nodes[at.node];
        if (node.split_axis != KD_LEAF) {
            count_node(work);
            at = next_child(node, origins[node.split_axis], inverses[node.split_axis], at.t_min,
                            at.t_max, &todo);
            count_waiting(work, todo.n);
            continue;
        }
        count_leaf(work);
        search_leaf(node, sphere_ids, spheres, ray, &hit, work);
        if (!next_waiting(hit, &todo, &at)) {
            return hit;
        }
    }
}
