// What the parts of the reference share.
#ifndef TESTS_REFERENCE_STEPS_H
#define TESTS_REFERENCE_STEPS_H

#include "reference.h"

// Write down a step, and count it as kernels/work.h does; but for leaves: a pixel in 2D has one,
// which is not counted.
void reference_add(Steps *steps, Step step);

// Write down all steps of a pixel among circles, or of a ray among spheres.
void reference2d_follow(const World *world, int x, int y, Steps *steps);
void reference3d_follow(const World *world, int x, int y, Steps *steps);

#endif
