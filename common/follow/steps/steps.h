// What one pixel does, step by step, as its own kernel writes it down: read by both compilers.
// The reference (../reference.h) writes the same.
//
// The kernels of the labs call count_test(), count_node() and the like where something is done
// (kernels/work.h). A .cl file of this folder puts other functions of these names in front of a
// lab's kernel, which write down what is at hand there. So what is said about a ray is what the
// student's own code does, and no second search has to agree with it.
// Read next: recording.h, record.h.
#ifndef FOLLOW_STEPS_H
#define FOLLOW_STEPS_H

#include "layout.h"

enum {
    STEP_NODE,  // a child of an inner node is chosen
    STEP_LEAF,  // a leaf is searched
    STEP_TEST,  // a circle or sphere is asked
    STEP_END,   // the pixel has its colour
};

// A node that waits on the todo stack.
typedef struct StepWaiting {
    /* 0 */ u32 node;
    /* 4 */ f32 t_min;
    /* 8 */ f32 t_max;
} StepWaiting;
LAYOUT_ASSERT(StepWaiting, 12);

// Those on top of the stack are written down. A step adds no more than two, so all of it is known.
#define MAX_STEP_WAITING 2

// Step.met: which children the ray meets, as children_on_ray() of lab 07 says it.
enum { MET_NEAR, MET_FAR, MET_BOTH };

typedef struct Step {
    /*  0 */ u32 kind;
    /*  4 */ u32 id;  // NODE, LEAF: the node. TEST: the element. END: the sphere that is hit; 2D:
                      // the leaf. NO_ID: none
    /*  8 */ u32 n_waiting;  // NODE, LEAF, 3D: how many nodes wait on the todo stack
    /* 12 */ f32 t_min;      // NODE, LEAF, 3D: the part of the ray inside it
    /* 16 */ f32 t_max;
    /* 20 */ f32 nearest;     // the nearest hit so far: its distance; 2D: its depth
    /* 24 */ f32 answer;      // TEST: the distance to the sphere; 2D: 1 or 0
    /* 28 */ f32 element[4];  // TEST: x, y, radius, depth or x, y, z, radius. 2D, END: the colour
    /* 44 */ u32 side;        // NODE, 3D: 0 when the lower child is the near one, else 1
    /* 48 */ u32 met;         // NODE, 3D: MET_...
    /* 52 */ f32 t_split;     // NODE, 3D: where the ray meets the plane; for MET_BOTH only
    /* 56 */ StepWaiting waiting[MAX_STEP_WAITING];  // NODE, LEAF, 3D: the top of the stack first
    /* 80 */ f32 slack;  // of the reference: by how much float may be off in t_min, t_max, t_split
    /* 84 */ u32 is_close;  // of the reference: rounding decides what comes next
} Step;
LAYOUT_ASSERT(Step, 88);

// More steps than this are counted and not kept, but for the last.
#define MAX_STEPS 500

// Step.id where there is none: no tree, no hit, an element that is not the scene's.
#define NO_ID 0xffffffffu

// It begins like a Work (kernels/work.h), and counts what that counts. Of a pixel in 2D the leaf is
// a step and not counted.
typedef struct Steps {
    u32 n_tests, n_nodes_visited, n_leaves_visited, stack_depth;
    u32 n_steps;       // all of them, STEP_END included
    f32 origin[3];     // of the ray; 3D
    f32 direction[3];  // a unit vector
    Step steps[MAX_STEPS];
} Steps;
LAYOUT_ASSERT(Steps, 44 + 88 * MAX_STEPS);

// How many of them were kept; the last one is always STEP_END.
static inline u32 steps_kept(u32 n_steps)
{
    return n_steps < MAX_STEPS ? n_steps : MAX_STEPS;
}

#endif
