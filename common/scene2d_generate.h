// The generators behind the scene names of scene2d.h: tables for scene2d.c, not for labs.
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Read next: scene2d_edge_cases.c.
#ifndef COMMON_SCENE2D_GENERATE_H
#define COMMON_SCENE2D_GENERATE_H

#include "scene2d.h"

// Generated coordinates are whole numbers of these steps a pixel.
#define SCENE2D_STEPS_PER_PIXEL 16

// One edge case. `draw` adds circles to a scene that has room for SCENE2D_EDGE_CASE_CIRCLES of them
// and already knows its width and height.
typedef struct SceneEdgeCase {
    const char *name;
    int width, height;  // the picture's size where the user gives none
    void (*draw)(Scene2D *scene);
} SceneEdgeCase;

#define SCENE2D_EDGE_CASE_CIRCLES 512

// All edge cases; the last has the name NULL.
extern const SceneEdgeCase SCENE2D_EDGE_CASES[];

#endif
