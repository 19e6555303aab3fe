// What one pixel does, step by step, as its own kernel writes it down: read by both compilers.
//
// The kernels of the labs call count_test(), count_node() and the like where something is done
// (kernels/work.h). A .cl file of this folder puts other functions of these names in front of a
// lab's kernel, which write down what is at hand there. So what is told about a ray is what the
// student's own code does, and no second search has to agree with it.
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: recording.h, record.h.
#ifndef VIEW_STEPS_H
#define VIEW_STEPS_H

#include "layout.h"

enum {
    STEP_NODE,  // a child of an inner node is chosen
    STEP_LEAF,  // a leaf is searched
    STEP_TEST,  // a circle or sphere is asked
    STEP_END,   // the pixel has its colour
};

typedef struct Step {
    /*  0 */ u32 kind;
    /*  4 */ u32 id;  // NODE, LEAF: the node. END: the sphere that is hit; 2D: the leaf, or NO_LEAF
    /*  8 */ u32 n_waiting;  // NODE, LEAF, 3D: how many nodes wait on the todo stack
    /* 12 */ f32 t_min;      // NODE, LEAF, 3D: the part of the ray inside it
    /* 16 */ f32 t_max;
    /* 20 */ f32 nearest;     // the nearest hit so far: its distance; 2D: its depth
    /* 24 */ f32 answer;      // TEST: the distance to the sphere; 2D: 1 or 0
    /* 28 */ f32 element[4];  // TEST: x, y, radius, depth or x, y, z, radius. 2D, END: the colour
} Step;
LAYOUT_ASSERT(Step, 44);

// More steps than this are counted and not kept, but for the last.
#define MAX_STEPS 500

// Step.id where there is no tree.
#define NO_LEAF 0xffffffffu

// It begins like a Work (kernels/work.h), as kernels set those four to 0.
typedef struct Steps {
    u32 n_tests, n_nodes_visited, n_leaves_visited, stack_depth;
    u32 n_steps;  // all of them, STEP_END included
    Step steps[MAX_STEPS];
} Steps;
LAYOUT_ASSERT(Steps, 20 + 44 * MAX_STEPS);

#endif
