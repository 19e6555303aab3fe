// Right answers of labs 06 and 07, in plain C.
//
// The builder is lab 06's solution, which the grader has in it. The search is written anew, in
// float as on the device: it calls itself instead of keeping a todo stack. Read next:
// right_answers.h.
#ifndef UNIT_RIGHT_ANSWERS_TREE3D_H
#define UNIT_RIGHT_ANSWERS_TREE3D_H

#include "jobs_06.h"
#include "jobs_07.h"
#include "kdtree3d_build.h"
#include "right_answers_3d.h"
#include "surroundings.h"

// ---- Lab 06 -------------------------------------------------------------------------------------

static void answer_planes_and_overlaps(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const BBox3D *cells = sections_find_any(job, "splits", &n_bytes);
    size_t n = n_bytes / sizeof *cells;
    KdSplit *splits = calloc(n, sizeof *splits);
    for (size_t i = 0; i < n; i++) {
        splits[i] = choose_split(cells[i]);
    }
    answer(writer, "splits", splits, n * sizeof *splits);
    free(splits);

    const SphereBoxJob *pairs = sections_find_any(job, "overlaps", &n_bytes);
    n = n_bytes / sizeof *pairs;
    i32 *decisions = calloc(n, sizeof *decisions);
    for (size_t i = 0; i < n; i++) {
        decisions[i] = sphere_overlaps_box(pairs[i].sphere, pairs[i].box);
    }
    answer(writer, "overlaps", decisions, n * sizeof *decisions);
    free(decisions);
}

static void answer_leaves_3d(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const PackJob *leaves = sections_find_any(job, "pack", &n_bytes);
    const size_t n = n_bytes / sizeof *leaves;
    PackAnswer3D *packed = calloc(n, sizeof *packed);
    for (size_t i = 0; i < n; i++) {
        for (u32 id = 0; id < PACK_NODES; id++) {
            packed[i].nodes[id] = PACK_NODE;
        }
        for (int j = 0; j < PACK_MAP_ROOM; j++) {
            packed[i].sphere_ids[j] = UNTOUCHED;
        }
        KdTree3D tree = {.nodes = packed[i].nodes,
                         .sphere_ids = packed[i].sphere_ids,
                         .n_nodes = PACK_NODES,
                         .n_sphere_ids = leaves[i].n_before};
        pack_leaf_range(&tree, leaves[i].id, leaves[i].ids, leaves[i].n_ids);
        packed[i].n_sphere_ids = tree.n_sphere_ids;
        packed[i].n_nodes = tree.n_nodes;
    }
    answer(writer, "pack", packed, n * sizeof *packed);
    free(packed);

    const LevelJob *levels = sections_find_any(job, "todo", &n_bytes);
    const size_t n_levels = n_bytes / sizeof *levels;
    i32 *todo = calloc(n_levels, sizeof *todo);
    for (size_t i = 0; i < n_levels; i++) {
        todo[i] = fits_todo((int)levels[i]);
    }
    answer(writer, "todo", todo, n_levels * sizeof *todo);
    free(todo);
}

typedef int Build(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree);

static void answer_trees_by(Writer *writer, const Sections *job, Build *build)
{
    const TreeJob3D *scene;
    for (int k = 0; (scene = sections_find(job, numbered("scene", k, NULL), sizeof *scene)); k++) {
        const Sphere *spheres = sphere_scene_part(job, k, "spheres");
        const KdTreeLimits limits = {scene->maxDepth, scene->targetElementsPerNode};
        KdTree3D tree;
        capture_begin(2);  // the builder says why it gives up
        const int is_refused = build(spheres, scene->n_spheres, limits, &tree) != 0;
        capture_end(2);
        if (is_refused) {
            answer(writer, numbered("tree", k, "refused"), "", 0);
            continue;
        }
        const TreeAnswer3D header = {tree.bounds, tree.n_nodes, tree.n_sphere_ids};
        answer(writer, numbered("tree", k, NULL), &header, sizeof header);
        answer(writer, numbered("tree", k, "nodes"), tree.nodes, tree.n_nodes * sizeof *tree.nodes);
        answer(writer, numbered("tree", k, "ids"), tree.sphere_ids,
               tree.n_sphere_ids * sizeof *tree.sphere_ids);
        tree3d_free(&tree);
    }
}

static void answer_trees_3d(Writer *writer, const Sections *job)
{
    answer_trees_by(writer, job, kdtree3d_build);
}

// ---- Lab 07: functions --------------------------------------------------------------------------

static float along(Vec3 v, u32 axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static ClipAnswer clip(BBox3D box, Ray ray, float t_min, float t_max)
{
    for (u32 axis = 0; axis < 3; axis++) {
        const float origin = along(ray.origin, axis), direction = along(ray.direction, axis);
        if (direction != 0) {
            const float a = (box.min[axis] - origin) / direction;
            const float b = (box.max[axis] - origin) / direction;
            t_min = fmaxf(t_min, fminf(a, b));
            t_max = fminf(t_max, fmaxf(a, b));
        } else if (origin < box.min[axis] || origin > box.max[axis]) {
            return (ClipAnswer){0, t_min, t_max};
        }
    }
    return (ClipAnswer){t_min <= t_max, t_min, t_max};
}

static u32 near_side(KdNode3 node, float origin, float inverse)
{
    return origin == node.split_pos ? inverse > 0 : origin > node.split_pos;
}

static PlaneAnswer children_on_ray(KdNode3 node, float origin, float inverse, float t_min,
                                   float t_max)
{
    const float t_split = (node.split_pos - origin) * inverse;
    const int is_met = t_split > 0 && t_split <= t_max;
    return (PlaneAnswer){!is_met           ? PLANE_ONLY_NEAR
                         : t_split < t_min ? PLANE_ONLY_FAR
                                           : PLANE_BOTH,
                         t_split};
}

static void search_leaf(KdNode3 leaf, const u32 *sphere_ids, const Sphere *spheres, Ray ray,
                        HitAnswer *hit, Work *work)
{
    for (u32 i = leaf.first; i < leaf.first + leaf.n_spheres; i++, work->n_tests++) {
        const u32 id = sphere_ids[i];
        const float t = intersect(spheres[id], ray, 0);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            *hit = (HitAnswer){t, id};
        }
    }
}

static void answer_clips_and_sides(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const ClipJob *rays = sections_find_any(job, "clips", &n_bytes);
    size_t n = n_bytes / sizeof *rays;
    ClipAnswer *clips = calloc(n, sizeof *clips);
    for (size_t i = 0; i < n; i++) {
        const Ray ray = {rays[i].origin, rays[i].direction};
        clips[i] = clip(rays[i].box, ray, rays[i].t_min, rays[i].t_max);
    }
    answer(writer, "clips", clips, n * sizeof *clips);
    free(clips);

    const SideJob *eyes = sections_find_any(job, "sides", &n_bytes);
    n = n_bytes / sizeof *eyes;
    u32 *sides = calloc(n, sizeof *sides);
    for (size_t i = 0; i < n; i++) {
        sides[i] = near_side(eyes[i].node, eyes[i].origin, eyes[i].inverse);
    }
    answer(writer, "sides", sides, n * sizeof *sides);
    free(sides);
}

static void answer_planes_and_leaves(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const PlaneJob *planes = sections_find_any(job, "planes", &n_bytes);
    size_t n = n_bytes / sizeof *planes;
    PlaneAnswer *children = calloc(n, sizeof *children);
    for (size_t i = 0; i < n; i++) {
        const PlaneJob in = planes[i];
        children[i] = children_on_ray(in.node, in.origin, in.inverse, in.t_min, in.t_max);
    }
    answer(writer, "planes", children, n * sizeof *children);
    free(children);

    const SearchJob *leaves = sections_find_any(job, "leaves", &n_bytes);
    n = n_bytes / sizeof *leaves;
    const u32 *ids = sections_find_any(job, "leaf_ids", &n_bytes);
    const Sphere *spheres = sections_find_any(job, "leaf_spheres", &n_bytes);
    SearchAnswer *searched = calloc(n, sizeof *searched);
    for (size_t i = 0; i < n; i++) {
        const Ray ray = {leaves[i].origin, leaves[i].direction};
        HitAnswer hit = {leaves[i].t, leaves[i].sphere};
        Work work = {0};
        search_leaf(leaves[i].node, ids, spheres, ray, &hit, &work);
        searched[i] = (SearchAnswer){hit.t, hit.sphere, work.n_tests};
    }
    answer(writer, "leaves", searched, n * sizeof *searched);
    free(searched);
}

// The far child waits where both are met.
static NextChildAnswer next_child(const NextChildJob *in)
{
    const u32 side = near_side(in->node, in->origin, in->inverse);
    const PlaneAnswer plane =
        children_on_ray(in->node, in->origin, in->inverse, in->t_min, in->t_max);
    const u32 chosen = plane.children == PLANE_ONLY_FAR ? !side : side;
    NextChildAnswer answer = {{in->node.first + chosen, in->t_min, in->t_max}, in->todo};
    if (plane.children == PLANE_BOTH) {
        answer.next.t_max = plane.t_split;
        answer.todo.upper[answer.todo.n++ - answer.todo.n_lower] =
            (TodoEntry){in->node.first + !side, plane.t_split, in->t_max};
    }
    return answer;
}

static void answer_steps(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const NextChildJob *nodes = sections_find_any(job, "next_child", &n_bytes);
    size_t n = n_bytes / sizeof *nodes;
    NextChildAnswer *children = calloc(n, sizeof *children);
    for (size_t i = 0; i < n; i++) {
        children[i] = next_child(&nodes[i]);
    }
    answer(writer, "next_child", children, n * sizeof *children);
    free(children);

    const NextWaitingJob *leaves = sections_find_any(job, "next_waiting", &n_bytes);
    n = n_bytes / sizeof *leaves;
    NextWaitingAnswer *waiting = calloc(n, sizeof *waiting);
    for (size_t i = 0; i < n; i++) {
        NextWaitingAnswer *out = &waiting[i];
        *out = (NextWaitingAnswer){0, leaves[i].at, leaves[i].todo};
        if (leaves[i].t >= leaves[i].at.t_max && out->todo.n > 0) {
            out->goes_on = 1;
            out->at = out->todo.upper[--out->todo.n - out->todo.n_lower];
        }
    }
    answer(writer, "next_waiting", waiting, n * sizeof *waiting);
    free(waiting);
}

// ---- Lab 07: the search -------------------------------------------------------------------------

// Search a node's part of the ray. Returns 1 when the search ends there. How many nodes wait is not
// counted: nobody judges it.
static int search_node(const SphereScene *scene, u32 id, Ray ray, float t_min, float t_max,
                       HitAnswer *hit, Work *work)
{
    const KdNode3 node = scene->nodes[id];
    if (node.split_axis == KD_LEAF) {
        work->n_leaves_visited++;
        search_leaf(node, scene->sphere_ids, scene->spheres, ray, hit, work);
        return hit->t < t_max;
    }
    work->n_nodes_visited++;
    const float origin = along(ray.origin, node.split_axis);
    const float inverse = 1 / along(ray.direction, node.split_axis);
    const u32 side = near_side(node, origin, inverse);
    const u32 near = node.first + side, far = node.first + !side;
    const PlaneAnswer plane = children_on_ray(node, origin, inverse, t_min, t_max);
    switch (plane.children) {
    case PLANE_ONLY_NEAR:
        return search_node(scene, near, ray, t_min, t_max, hit, work);
    case PLANE_ONLY_FAR:
        return search_node(scene, far, ray, t_min, t_max, hit, work);
    default:
        return search_node(scene, near, ray, t_min, plane.t_split, hit, work) ||
               search_node(scene, far, ray, plane.t_split, t_max, hit, work);
    }
}

static HitAnswer find_in_tree(const SphereScene *scene, Ray ray, Work *work)
{
    HitAnswer hit = no_hit;
    const ClipAnswer inside = clip(scene->job->bounds, ray, 0, INFINITY);
    if (inside.is_met) {
        search_node(scene, 0, ray, inside.t_min, inside.t_max, &hit, work);
    }
    return hit;
}

#endif
