// The todo stacks of lab 07's inputs and answers. All their numbers are quarters, so that nothing
// is rounded: an answer is right or wrong to the bit.
#ifndef GRADER_JUDGE_07_STACK_H
#define GRADER_JUDGE_07_STACK_H

#include "jobs.h"
#include "random.h"

// A number of quarters, from lowest to highest of them.
float random_quarters(Random *random, int lowest, int highest);

// A stack with n_upper nodes on n_lower others; their parts lie beyond every node's at hand.
StackState random_stack(Random *random, u32 n_lower, u32 n_upper);

int same_entry(StackEntry a, StackEntry b);

// Do the same nodes wait? What lies above the top does not matter.
int same_stack(const StackState *a, const StackState *b);

#endif
