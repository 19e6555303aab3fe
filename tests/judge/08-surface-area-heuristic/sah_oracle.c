// See sah_oracle.h.
#include "sah_oracle.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

// ---- What a split costs -------------------------------------------------------------------------

double sah_area(BBox3D box)
{
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    return 2 * (x * y + y * z + z * x);
}

BBox3D sah_lower(CostJob split)
{
    split.box.max[split.axis] = split.pos;
    return split.box;
}

BBox3D sah_higher(CostJob split)
{
    split.box.min[split.axis] = split.pos;
    return split.box;
}

double sah_cost(CostJob split)
{
    const double n_expected = (sah_area(sah_lower(split)) * split.n_lower +
                               sah_area(sah_higher(split)) * split.n_higher) /
                              sah_area(split.box);
    return SAH_TRAVERSAL + SAH_TEST * n_expected;
}

// ---- Planes -------------------------------------------------------------------------------------

f32 sah_plane_at(BBox3D box, u32 axis, int i)
{
    const f32 side = box.max[axis] - box.min[axis];
    return box.min[axis] + side * ((f32)i / SAH_BINS);
}

int sah_plane_number(BBox3D box, u32 axis, f32 pos)
{
    int i = SAH_BINS - 1;
    while (i > 0 && sah_plane_at(box, axis, i) != pos) {
        i--;
    }
    return i;
}

f32 sah_centre(Sphere sphere, u32 axis)
{
    return axis == 0 ? sphere.x : axis == 1 ? sphere.y : sphere.z;
}

SahPlane sah_weigh(const SahNode *node, u32 axis, int i)
{
    const f32 pos = sah_plane_at(node->box, axis, i);
    CostJob split = {node->box, axis, pos, 0, 0}, least = split, most = split;
    for (u32 j = 0; j < node->n_ids; j++) {
        const Sphere sphere = node->spheres[node->ids[j]];
        const f32 centre = sah_centre(sphere, axis), radius = fabsf(sphere.radius);
        const f32 begin = centre - radius, end = centre + radius;
        // In float and exactly: where they differ, rounding decides.
        const int is_lower = begin <= pos, is_exactly_lower = (double)centre - radius <= pos;
        const int is_higher = end >= pos, is_exactly_higher = (double)centre + radius >= pos;
        const int is_sure = node->may_lack == NULL || !node->may_lack[j];
        split.n_lower += (u32)is_lower;
        split.n_higher += (u32)is_higher;
        least.n_lower += (u32)(is_lower && is_exactly_lower && is_sure);
        least.n_higher += (u32)(is_higher && is_exactly_higher && is_sure);
        most.n_lower += (u32)(is_lower || is_exactly_lower);
        most.n_higher += (u32)(is_higher || is_exactly_higher);
    }
    return (SahPlane){axis, pos, sah_cost(split), sah_cost(least), sah_cost(most)};
}

SahPlane sah_best(const SahNode *node)
{
    SahPlane best = {.cost = INFINITY, .least = INFINITY, .most = INFINITY};
    if (sah_area(node->box) == 0) {
        return best;
    }
    for (u32 axis = 0; axis < 3; axis++) {
        for (int i = 1; i < SAH_BINS; i++) {
            const SahPlane plane = sah_weigh(node, axis, i);
            const double least = fmin(best.least, plane.least);
            const double most = fmin(best.most, plane.most);
            best = plane.cost < best.cost ? plane : best;
            best.least = least;
            best.most = most;
        }
    }
    return best;
}

int sah_is_tied(const SahNode *node, const SahPlane *best)
{
    for (u32 axis = 0; axis < 3; axis++) {
        for (int i = 1; i < SAH_BINS; i++) {
            const SahPlane plane = sah_weigh(node, axis, i);
            const int is_other = plane.axis != best->axis || plane.pos != best->pos;
            if (is_other && plane.least <= best->most * (1 + 2 * SAH_COST_TOLERANCE)) {
                return 1;
            }
        }
    }
    return 0;
}
