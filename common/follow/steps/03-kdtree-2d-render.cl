// Lab 03's kernel, writing down the steps of a pixel (steps.h).
//
// Started by record.c.
#include "circles.h"
#define work_save(work, x, y, width, d_work) steps_save(&work, x, y, color, id, d_work)

// In getContainingChild(): the inner node.
#define count_node(work) step_inner(work, id)
static inline void step_inner(Work *work, uint id)
{
    const Step step = {.kind = STEP_NODE, .id = id};
    step_add(work, step);
}

#include "implicit2DRenderer_KD.cl"
