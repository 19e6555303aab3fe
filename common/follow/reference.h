// What a right kernel does for a pixel, computed on the host in double precision.
//
// It knows the answers, so it lies with the tests (tests/follow) and is in no handout: there
// no_reference.c says that there is none.
// Read next: followed.h.
#ifndef FOLLOW_REFERENCE_H
#define FOLLOW_REFERENCE_H

#include "steps/steps.h"
#include "world.h"

// Follow pixel x, y through the same tree as the kernel. Sets `slack` and `is_close` of each step,
// too. Returns 0, or -1 where there is no reference.
int reference_follow(const World *world, int x, int y, Steps *steps);

#endif
