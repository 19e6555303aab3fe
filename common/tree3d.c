// Releasing, checking and measuring the 3D kd-tree's arrays (see tree3d.h).
//
// Between lab 06, whose kdtree3d_build.c fills the arrays, and lab 07, which copies them to the
// device. Read next: tree3d_draw.c.
#include "tree3d.h"

#include "complain.h"

#include <math.h>
#include <stdlib.h>

void tree3d_free(KdTree3D *tree)
{
    free(tree->nodes);
    free(tree->sphere_ids);
    *tree = (KdTree3D){0};
}

// Zeros, one a node, for the walks below: a node finds the level of its deepest parent there and
// adds 1. Returns NULL after one message when memory runs out; free() it.
static int *levels_create(const KdTree3D *tree)
{
    // calloc() may answer NULL to a size of 0.
    int *levels = calloc((size_t)tree->n_nodes + 1, sizeof *levels);
    if (levels == NULL) {
        complain("tree: no memory for the levels of %u nodes", tree->n_nodes);
    }
    return levels;
}

// Note in levels[] what lies above the children of a node on this level.
static void levels_pass_on(int *levels, KdNode3 node, int level)
{
    for (u32 child = node.first; child < node.first + 2; child++) {
        levels[child] = level > levels[child] ? level : levels[child];
    }
}

static int check_inner(const KdTree3D *tree, u32 id)
{
    const u32 first = tree->nodes[id].first;
    if (tree->nodes[id].split_axis > KD_LEAF) {
        complain("tree: node %u: found split_axis %u, expected 0, 1, 2 or %d (KD_LEAF)", id,
                 tree->nodes[id].split_axis, KD_LEAF);
        return -1;
    }
    if (first <= id || first >= tree->n_nodes - 1) {
        complain("tree: node %u: found its children at %u and %u, expected ids from %u to %u", id,
                 first, first + 1, id + 1, tree->n_nodes - 1);
        return -1;
    }
    return 0;
}

static int check_leaf(const KdTree3D *tree, u32 id, u32 n_spheres)
{
    const KdNode3 node = tree->nodes[id];
    if (node.first > tree->n_sphere_ids || node.n_spheres > tree->n_sphere_ids - node.first) {
        complain("tree: leaf %u: found %u ids from %u on, but there are %u ids", id, node.n_spheres,
                 node.first, tree->n_sphere_ids);
        return -1;
    }
    for (u32 i = 0; i < node.n_spheres; i++) {
        const u32 sphere = tree->sphere_ids[node.first + i];
        if (sphere >= n_spheres) {
            complain("tree: leaf %u: found sphere id %u, but the scene has %u spheres", id, sphere,
                     n_spheres);
            return -1;
        }
    }
    return 0;
}

int tree3d_check(const KdTree3D *tree, u32 n_spheres)
{
    if (tree->n_nodes == 0) {
        complain("tree: found no node, expected a root");
        return -1;
    }
    int *levels = levels_create(tree);
    int result = levels != NULL ? 0 : -1;
    for (u32 id = 0; result == 0 && id < tree->n_nodes; id++) {
        const KdNode3 node = tree->nodes[id];
        const int level = ++levels[id];
        if (node.split_axis == KD_LEAF) {
            result = check_leaf(tree, id, n_spheres);
        } else if (check_inner(tree, id) != 0) {
            result = -1;
        } else if (level > TODO_SIZE) {
            complain("tree: node %u: split on level %d, but the todo stack has %d places", id,
                     level, TODO_SIZE);
            result = -1;
        } else {
            levels_pass_on(levels, node, level);
        }
    }
    free(levels);
    return result;
}

int tree3d_figures(const KdTree3D *tree, TreeFigures3D *figures)
{
    int *levels = levels_create(tree);
    if (levels == NULL) {
        return -1;
    }
    *figures = (TreeFigures3D){0};
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const KdNode3 node = tree->nodes[id];
        const int level = ++levels[id];
        figures->depth = level > figures->depth ? level : figures->depth;
        if (node.split_axis == KD_LEAF) {
            figures->n_leaves++;
            figures->n_empty += node.n_spheres == 0;
            figures->largest_leaf =
                node.n_spheres > figures->largest_leaf ? node.n_spheres : figures->largest_leaf;
        } else {
            levels_pass_on(levels, node, level);
        }
    }
    free(levels);
    return 0;
}

BBox3D box_widened(BBox3D box)
{
    for (int axis = 0; axis < 3; axis++) {
        box.min[axis] = nextafterf(box.min[axis], -INFINITY);
        box.max[axis] = nextafterf(box.max[axis], INFINITY);
    }
    return box;
}

// What came out fastest for scenes of 7381, 100 000 and 1 000 000 spheres: leaves of
// some spheres, and levels enough to get there and a few more, as cells halve in one direction
// only.
enum { DEFAULT_LEAF_SIZE = 6, EXTRA_LEVELS = 6 };

KdTreeLimits tree3d_limits(int max_depth, int leaf_size, u32 n_spheres)
{
    int n_doublings = 0;
    while (n_spheres >> n_doublings > 1) {
        n_doublings++;
    }
    return (KdTreeLimits){max_depth > 0 ? max_depth : n_doublings + EXTRA_LEVELS,
                          leaf_size > 0 ? leaf_size : DEFAULT_LEAF_SIZE};
}
