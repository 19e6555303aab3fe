// Lab 06: building the 3D kd-tree.
//
// Flow: scene -> BUFFERS (this file fills the tree's) -> kernel -> image. Called by main.c here and
// in lab 07. Read the contracts in kdtree3d_build.h first, then kdtree3d_build() at the end, which
// passes the steps to tree3d_grow(). Given, because lab 02 has taught it: is_leaf(), the scene's
// box, the lists of the children, and the building level by level.
#include "kdtree3d_build.h"

#include "kdtree2d_build.h"

#include <math.h>

BBox3D spheres_bounds(const Sphere *h_spheres, u32 n_spheres)
{
    if (n_spheres == 0) {
        return (BBox3D){{0}, {0}};
    }
    BBox3D box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (u32 i = 0; i < n_spheres; i++) {
        const f32 centre[3] = {h_spheres[i].x, h_spheres[i].y, h_spheres[i].z};
        const f32 radius = fabsf(h_spheres[i].radius);
        for (int axis = 0; axis < 3; axis++) {
            box.min[axis] = fminf(box.min[axis], centre[axis] - radius);
            box.max[axis] = fmaxf(box.max[axis], centre[axis] + radius);
        }
    }
    return box;
}

KdSplit choose_split(BBox3D box)
{
    KdSplit split = {0, 0};
    // TASK choose_split: split the longest side in its middle. If sides are equal, take the axis
    // that comes first.
    (void)box;
    // END choose_split
    return split;
}

// How far a coordinate is outside of [min, max], on either side; 0 inside. In double next to
// nothing is lost to rounding. (Two plain choices: compilers make them without a jump, and the
// building spends most of its time here.)
static double outside(double coordinate, double min, double max)
{
    const double raised = coordinate < min ? min : coordinate;
    const double nearest = raised > max ? max : raised;
    return coordinate - nearest;
}

int sphere_overlaps_box(Sphere sphere, BBox3D box)
{
    // TASK sphere_overlaps_box: outside() on each axis gives the distance from the centre to the
    // cell's nearest point. Does the sphere reach that far?
    (void)sphere, (void)box, (void)outside;
    return 0;
    // END sphere_overlaps_box
}

u32 distribute_spheres(const Sphere *h_spheres, const u32 *ids, u32 n_ids, BBox3D child,
                       u32 *child_ids)
{
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        fetch_ahead(h_spheres, ids, n_ids, i);
        // Always written, kept only if it overlaps: the processor would guess an `if` wrongly half
        // of the time, which costs more than the test.
        child_ids[n_child_ids] = ids[i];
        n_child_ids += (u32)sphere_overlaps_box(h_spheres[ids[i]], child);
    }
    return n_child_ids;
}

void pack_leaf_range(KdTree3D *tree, u32 id, const u32 *ids, u32 n_ids)
{
    // TASK pack_leaf_range: a leaf is marked by its split_axis; its range starts where the array
    // ends now. Unlike in lab 02 the count is in the node and not in the array.
    (void)tree, (void)id, (void)ids, (void)n_ids;
    // END pack_leaf_range
}

int fits_todo(int level)
{
    // TASK fits_todo: the children of a node are one level deeper. How many nodes can wait at most
    // while a search is at one of them?
    (void)level;
    return 0;
    // END fits_todo
}

// Decide whether a node stays a leaf or is split (ChooseSplit of tree3d_grow.h).
static int choose_middle(const void *limits, const KdOpenNode *node, KdSplit *split)
{
    if (is_leaf(node->level, node->n_ids, node->n_failed, *(const KdTreeLimits *)limits)) {
        return 0;
    }
    *split = choose_split(node->box);
    return 1;
}

int kdtree3d_build(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree)
{
    const KdSteps steps = {"kdtree3d_build",   choose_middle,   &limits,
                           distribute_spheres, pack_leaf_range, fits_todo};
    return tree3d_grow(&steps, h_spheres, n_spheres, spheres_bounds(h_spheres, n_spheres), tree);
}
