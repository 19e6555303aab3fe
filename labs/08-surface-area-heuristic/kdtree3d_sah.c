// Lab 08: building the 3D kd-tree by the surface area heuristic.
//
// Flow: scene -> BUFFERS (this file fills the tree's) -> kernel -> image. Called by main.c. Read
// the contracts in kdtree3d_sah.h first, then choose_by_cost() and kdtree3d_build_sah() at the end:
// only what they call for a node's split is new here.
#include "kdtree3d_sah.h"

#include "kdtree3d_build.h"

#include <math.h>

double surface_area(BBox3D box)
{
    // TASK surface_area: the area of all six faces.
    (void)box;
    return 0;
    // END surface_area
}

double split_cost(BBox3D box, KdSplit split, u32 n_lower, u32 n_higher)
{
    // TASK split_cost: a ray that meets the cell meets a child with probability area over area, and
    // then tests that child's spheres.
    (void)box, (void)split, (void)n_lower, (void)n_higher;
    return 0;
    // END split_cost
}

f32 candidate_plane(BBox3D box, u32 axis, int i)
{
    return box.min[axis] + (box.max[axis] - box.min[axis]) * ((f32)i / N_BINS);
}

// The candidate planes of one axis, in a table: each sphere is compared with some of them.
typedef struct Planes {
    f32 pos[N_BINS + 1];  // of plane i; before the first one -INFINITY, behind the last INFINITY
    f32 min;              // where the cell begins
    f32 bins_per_unit;
} Planes;

static Planes axis_planes(BBox3D box, u32 axis)
{
    Planes planes = {.min = box.min[axis],
                     .bins_per_unit = N_BINS / (box.max[axis] - box.min[axis])};
    planes.pos[0] = -INFINITY;
    for (int i = 1; i < N_BINS; i++) {
        planes.pos[i] = candidate_plane(box, axis, i);
    }
    planes.pos[N_BINS] = INFINITY;
    return planes;
}

// In which bin does a coordinate lie, by a multiplication? It only guesses: float may round it over
// a plane. (Two plain choices: compilers make them without a jump. Many coordinates are outside of
// the cell, and a jump there would be foreseen wrongly half of the time.)
static int guess_bin(const Planes *planes, f32 coordinate)
{
    const f32 bin = (coordinate - planes->min) * planes->bins_per_unit;
    const f32 lowered = bin < N_BINS - 1 ? bin : N_BINS - 1;
    return (int)(lowered > 0 ? lowered : 0);
}

// In which bin does a coordinate lie: how many of the candidate planes are below it? From 0 to
// N_BINS - 1. The guess is nearly always right: each loop tests one plane, and ends.
static int planes_below(const Planes *planes, f32 coordinate)
{
    int n = guess_bin(planes, coordinate);
    while (planes->pos[n] >= coordinate && n > 0) {
        n--;
    }
    while (planes->pos[n + 1] < coordinate && n < N_BINS - 1) {
        n++;
    }
    return n;
}

// The same, with the planes at the coordinate itself.
static int planes_up_to(const Planes *planes, f32 coordinate)
{
    int n = guess_bin(planes, coordinate);
    while (planes->pos[n] > coordinate && n > 0) {
        n--;
    }
    while (planes->pos[n + 1] <= coordinate && n < N_BINS - 1) {
        n++;
    }
    return n;
}

// The part of an axis that a sphere takes up.
typedef struct Range {
    f32 begin, end;
} Range;

static Range sphere_range(Sphere sphere, u32 axis)
{
    const f32 centre = axis == 0 ? sphere.x : axis == 1 ? sphere.y : sphere.z;
    const f32 radius = fabsf(sphere.radius);
    return (Range){centre - radius, centre + radius};
}

BestSplit find_best_split(const Sphere *h_spheres, const u32 *ids, u32 n_ids, BBox3D box)
{
    BestSplit best = {{0, 0}, INFINITY};
    // TASK find_best_split: for each axis count into bins where the spheres' ranges begin and where
    // they end. Sums from bin to bin then give what either child has at each plane.
    (void)h_spheres, (void)ids, (void)n_ids, (void)box;
    (void)sphere_range, (void)axis_planes, (void)planes_below, (void)planes_up_to;
    // END find_best_split
    return best;
}

int is_leaf_by_cost(int level, u32 n_spheres, double best_cost, KdTreeLimits limits)
{
    // TASK is_leaf_by_cost: two limits, and one comparison of costs.
    (void)level, (void)n_spheres, (void)best_cost, (void)limits;
    return 1;
    // END is_leaf_by_cost
}

// What a node's split needs to know.
typedef struct Rules {
    const Sphere *h_spheres;
    KdTreeLimits limits;
} Rules;

// A node's turn comes: it stays a leaf, or is split (ChooseSplit of tree3d_grow.h).
static int choose_by_cost(const void *pointer, const KdOpenNode *node, KdSplit *split)
{
    const Rules *rules = pointer;
    const BestSplit best = find_best_split(rules->h_spheres, node->ids, node->n_ids, node->box);
    *split = best.split;
    return !is_leaf_by_cost(node->level, node->n_ids, best.cost, rules->limits);
}

int kdtree3d_build_sah(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree)
{
    const Rules rules = {h_spheres, limits};
    const KdSteps steps = {"kdtree3d_build_sah", choose_by_cost,  &rules,
                           distribute_spheres,   pack_leaf_range, fits_todo};
    return tree3d_grow(&steps, h_spheres, n_spheres, spheres_bounds(h_spheres, n_spheres), tree);
}
