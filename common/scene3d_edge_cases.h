// The 3D edge cases, for scene3d_generate.c, which finds them by name; labs do not need it.
//
// Read next: scene3d_edge_cases.c.
#ifndef COMMON_SCENE3D_EDGE_CASES_H
#define COMMON_SCENE3D_EDGE_CASES_H

#include "scene3d.h"

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

#endif
