// The 2D edge cases, for scene2d_generate.c, which finds them by name; labs do not need it.
//
// Read next: scene2d_edge_cases.c.
#ifndef COMMON_SCENE2D_EDGE_CASES_H
#define COMMON_SCENE2D_EDGE_CASES_H

#include "scene2d.h"

// The most circles of an edge case.
#define SCENE2D_EDGE_CASE_CIRCLES 512

// One edge case. `draw` adds circles to a scene that knows its size and has room for
// SCENE2D_EDGE_CASE_CIRCLES of them.
typedef struct SceneEdgeCase {
    const char *name;
    void (*draw)(Scene2D *scene);
    int width, height;  // the picture's size where the user gives none; 0, 0: the usual one
} SceneEdgeCase;

// All edge cases; the last has the name NULL.
extern const SceneEdgeCase SCENE2D_EDGE_CASES[];

#endif
