// A kd-tree for lab 07's kernel: built, checked, described in figures and copied to the device.
// Given; main.c of lab 07 has the same steps in it, one by one.
#ifndef TREE_BUFFERS_H
#define TREE_BUFFERS_H

#include "lab.h"
#include "scene3d.h"
#include "tree3d.h"

typedef struct TreeBuffers {
    cl_mem d_nodes;
    cl_mem d_sphere_ids;
    BBox3D bounds;  // widened: see box_widened()
} TreeBuffers;

// kdtree3d_build() of lab 06, or kdtree3d_build_sah().
typedef int BuildTree(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree);

// Build a tree over the scene's spheres and copy it to the device.
//   name   what the figures are called by: NAME.build_ms, and those of tree_report()
// Returns 0, or -1 after one message on stderr. Release with tree_buffers_free().
int tree_buffers_create(Lab *lab, const Scene3D *scene, const char *name, BuildTree *build,
                        KdTreeLimits limits, TreeBuffers *buffers);

// Release them; zeroed TreeBuffers are fine.
void tree_buffers_free(TreeBuffers *buffers);

// Set a kernel's arguments 10 to 12: nodes, sphere_ids, bounds.
void tree_buffers_set(const TreeBuffers *buffers, cl_kernel kernel);

#endif
