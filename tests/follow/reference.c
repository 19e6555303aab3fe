// What a right kernel does for a pixel (see common/follow/reference.h).
#include "reference_steps.h"

void reference_add(Steps *steps, Step step)
{
    steps->n_tests += step.kind == STEP_TEST;
    steps->n_nodes_visited += step.kind == STEP_NODE;
    if (steps->n_steps < MAX_STEPS || step.kind == STEP_END) {
        steps->steps[steps->n_steps < MAX_STEPS ? steps->n_steps : MAX_STEPS - 1] = step;
    }
    steps->n_steps++;
}

int reference_follow(const World *world, int x, int y, Steps *steps)
{
    *steps = (Steps){0};
    if (world->kind == &CIRCLES) {
        reference2d_follow(world, x, y, steps);
    } else {
        reference3d_follow(world, x, y, steps);
    }
    return 0;
}
