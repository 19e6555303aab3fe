// What a ray needs of the scene: the spheres, their materials, the lights, and the tree over the
// spheres. Device only. It holds a kernel's parameters, so that functions take one argument instead
// of nine.
//
// Flow: scene -> buffers -> KERNEL -> image. Read next: shadows.cl.
#ifndef TRACED_SCENE_H
#define TRACED_SCENE_H

#include "kdtree3d.h"
#include "shading.h"
#include "sphere.h"

typedef struct TracedScene {
    global const Sphere *spheres;
    global const uint *material_ids;   // what each sphere is made of: an index into materials
    global const Material *materials;  // shading.h
    global const Light *lights;        // [n_lights]
    int n_lights;
    float3 background;            // the colour of a ray that hits nothing
    global const KdNode3 *nodes;  // the tree of lab 06 (kdtree3d.h); node 0 is the root
    global const uint *sphere_ids;
    BBox3D bounds;
} TracedScene;

#endif
