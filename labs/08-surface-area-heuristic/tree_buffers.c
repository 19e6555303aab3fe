// A kd-tree for lab 07's kernel (see tree_buffers.h).
//
// Flow: scene -> BUFFERS -> kernel -> image. Read next: tree_report.c, main.c.
#include "tree_buffers.h"

#include "cl_memory.h"
#include "tree_report.h"

int tree_buffers_create(Lab *lab, const Scene3D *scene, const char *name, BuildTree *build,
                        KdTreeLimits limits, TreeBuffers *buffers)
{
    const u32 n_spheres = (u32)scene->n_spheres;
    KdTree3D tree;
    const double start = stats_clock_ms();
    if (build(scene->spheres, n_spheres, limits, &tree) != 0) {
        return -1;
    }
    const double build_ms = stats_clock_ms() - start;
    // The kernel follows every id without asking.
    int result = tree3d_check(&tree, n_spheres);
    result = result == 0 ? tree_report(&tree, name, build_ms, &lab->stats) : result;
    if (result == 0) {
        *buffers = (TreeBuffers){
            .d_nodes = cl_buffer_create(&lab->cl, tree.nodes, tree.n_nodes * sizeof(KdNode3)),
            .d_sphere_ids =
                cl_buffer_create(&lab->cl, tree.sphere_ids, tree.n_sphere_ids * sizeof(u32)),
            .bounds = box_widened(tree.bounds)};
    }
    tree3d_free(&tree);
    return result;
}

void tree_buffers_free(TreeBuffers *buffers)
{
    const cl_mem memory[] = {buffers->d_nodes, buffers->d_sphere_ids};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    *buffers = (TreeBuffers){0};
}

void tree_buffers_set(const TreeBuffers *buffers, cl_kernel kernel)
{
    CL_CHECK(clSetKernelArg(kernel, 10, sizeof buffers->d_nodes, &buffers->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, 11, sizeof buffers->d_sphere_ids, &buffers->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, 12, sizeof buffers->bounds, &buffers->bounds));
}
