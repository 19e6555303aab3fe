// What the steps of a pixel among circles are: shared by the kernels of labs 01 and 03.
//
// Read next: 03-kdtree-2d-render.cl.
#ifndef FOLLOW_STEPS_CIRCLES_H
#define FOLLOW_STEPS_CIRCLES_H

#include "circle.h"
#include "recording.h"

int overlaps_N_Nearer(int x, int y, Circle circle, float minDepth, Work *work);

// In overlaps_N_Nearer(): the circle that is asked, and the depth it has to be nearer than.
#define count_test(work) step_circle(work, circle, minDepth)
static inline void step_circle(Work *work, Circle circle, float minDepth)
{
    const Step step = {.kind = STEP_TEST,
                       .nearest = minDepth,
                       .element = {circle.x, circle.y, circle.radius, circle.depth}};
    step_add(work, step);
}

static Circle step_asks(Step step)
{
    const Circle circle = {.x = step.element[0],
                           .y = step.element[1],
                           .radius = step.element[2],
                           .depth = step.element[3]};
    return circle;
}

// At the end of the kernel: the colour, and the leaf it is from, or NO_ID.
static void steps_save(Work *work, int x, int y, float4 color, uint leaf, global Work *d_steps)
{
    ANSWER_ALL(work, overlaps_N_Nearer(x, y, step_asks(step), step.nearest, work));
    const Step end = {
        .kind = STEP_END, .id = leaf, .element = {color.x, color.y, color.z, color.w}};
    step_add(work, end);
    *d_steps = *work;
}

#endif
