// Bytes and operations a ray (see roofline.h).
#include "roofline.h"

#include <stdio.h>

// Counted in the text of lab 07's and lab 05's kernels, without the making of rays and the shading:
// +, -, *, sqrt and comparisons of numbers. A node: near_side() 2, children_on_ray() 5. A test:
// intersect_sphere() 21, nearest_root() 6, the leaf's own comparison 1.
enum { OPERATIONS_A_NODE = 7, OPERATIONS_A_TEST = 28 };

static double bytes_of_ray(WorkOfRay work)
{
    return (work.n_nodes + work.n_leaves) * sizeof(KdNode3) +
           work.n_tests * (sizeof(u32) + sizeof(Sphere));
}

static double operations_of_ray(WorkOfRay work)
{
    return work.n_nodes * OPERATIONS_A_NODE + work.n_tests * OPERATIONS_A_TEST;
}

void roofline_print(const Case3D *cases, int n_cases)
{
    printf(
        "\nWhat a ray of the kd-tree's kernel reads and computes in the search; steps are inner "
        "nodes, leaves\nand spheres, and of %d neighbouring rays side by side all take as many as "
        "the slowest\n",
        WORK_GROUP_WIDTH * WORK_GROUP_HEIGHT);
    printf("  %-16s  %6s  %10s  %7s  %7s  %6s  %11s\n", "scene", "bytes", "operations", "GB/s",
           "Gop/s", "steps", "of slowest");
    for (int i = 0; i < n_cases; i++) {
        const WorkOfRay work = cases[i].work;
        const Series *frames = &cases[i].frames[KDTREE];
        const double giga_rays =
            (double)CASE3D_SIDE * CASE3D_SIDE / 1e6 / spread_of(frames->ms, frames->n).median;
        printf("  %-16s  %6.0f  %10.0f  %7.3g  %7.3g  %6.1f  %11.1f\n", cases[i].scene_name,
               bytes_of_ray(work), operations_of_ray(work), bytes_of_ray(work) * giga_rays,
               operations_of_ray(work) * giga_rays, work.n_nodes + work.n_leaves + work.n_tests,
               work.n_slowest_steps);
    }
    printf(
        "  Nodes and spheres are read again and again: what caches give, not what memory does.\n");
}
