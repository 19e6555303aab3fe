// What the world of spheres keeps: spheres.c's, and lab 10's, whose kernel takes more of it.
//
// Read next: spheres.c.
#ifndef FOLLOW_WORLD_SPHERES_H
#define FOLLOW_WORLD_SPHERES_H

#include "scene3d.h"
#include "scene_buffers.h"
#include "world.h"

typedef struct Spheres {
    Scene3D scene;  // its view is that of the world's pose
    SceneBuffers buffers;
    KdTree3D tree;
    BBox3D bounds;  // of the tree, a little wider
    cl_mem d_nodes, d_sphere_ids;
    cl_mem d_leaf_spheres, d_pixels;  // of lab 10's tree, else NULL: see its tile_buffers.h
} Spheres;

#endif
