// What scene3d.c and the files of the 3D generators share; labs do not need it.
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Read next: scene3d_lattice.c, the
// shortest generator.
#ifndef COMMON_SCENE3D_GENERATE_H
#define COMMON_SCENE3D_GENERATE_H

#include "scene3d.h"

// Make room for a scene of this many spheres, materials and lights, all zero, and give it the
// usual view: seen from `from` towards the origin, z up, 45 degrees. Sphere i is of material
// i % n_materials: its own where there are as many. Spheres need a material.
// Leaves width and height alone. Returns 0, or -1 after one message on stderr (no memory).
int scene3d_create(int n_spheres, int n_materials, int n_lights, Vec3 from, Scene3D *scene);

// The brightness of each of n lights that together are as bright as NFF has it: 1 / sqrt(n).
Vec3 scene3d_light_color(int n_lights);

// The most spheres of an edge case.
#define SCENE3D_EDGE_CASE_SPHERES 512

// One edge case. `place` adds spheres to a scene that has room for SCENE3D_EDGE_CASE_SPHERES of
// them and has its materials and lights, and sets the view where it is not the usual one.
typedef struct Scene3DEdgeCase {
    const char *name;
    void (*place)(Scene3D *scene);
    int width, height;  // the picture's size where the user gives none; 0, 0: the usual one
} Scene3DEdgeCase;

// All edge cases; the last has the name NULL.
extern const Scene3DEdgeCase SCENE3D_EDGE_CASES[];

// Make the edge case's scene. Sets everything, width and height only where the edge case has its
// own. Returns 0, or -1 after one message on stderr (no memory).
int scene3d_edge_case_open(const Scene3DEdgeCase *edge_case, Scene3D *scene);

// Complete a scene: a light at the eye where it has none, the size that the user gave, and a view
// that can be drawn at it.
//   made   0, or -1 where reading or making it has failed, after one message
// Returns 0, or -1 after one message; the scene is then released.
int scene3d_settle(const char *name, int width, int height, int made, Scene3D *scene);

#endif
