// The todo stacks of inputs and answers, for labs 07 and 10. All their numbers are quarters, so
// that nothing is rounded: an answer is right or wrong to the bit.
#ifndef JUDGE_JOB_STACK_H
#define JUDGE_JOB_STACK_H

#include "jobs_07.h"
#include "random.h"
#include "words.h"

// What crashes a step that has nothing to take.
#define TAKEN_FROM_EMPTY "taken from an empty stack: nothing was waiting"

// A number of quarters, from lowest to highest of them.
float random_quarters(Random *random, int lowest, int highest);

// A stack with n_upper nodes on n_lower others; their parts lie beyond every node's at hand.
StackState random_stack(Random *random, u32 n_lower, u32 n_upper);

// The same as a step meets it before it puts one more on it: empty below or of any height, and one
// in eight with a single place left.
StackState random_stack_with_room(Random *random);

// As a search of single rays leaves it: the top part begins at t, where the part at hand ends, and
// each other one where the part above it ends.
void stack_begin_at(StackState *todo, float t);

// Make all distances of a stack `factor` times as long.
void stack_scale(StackState *todo, float factor);

int same_entry(TodoEntry a, TodoEntry b);

// Do the same nodes wait, as far as they are known? What lies above the top does not matter.
int same_stack(const StackState *a, const StackState *b);

// Does the search end in both, or go on with the same? Where it is over, at and todo do not matter.
int same_waiting(const NextWaitingAnswer *found, NextWaitingAnswer expected);

// An answer with another part of the node that is handed on, and with one more node on the stack.
NextWaitingAnswer with_part(NextWaitingAnswer answer, float t_min, float t_max);
NextWaitingAnswer with_one_more(NextWaitingAnswer answer);

// "node 12 with [1, 4], and node 13 with [4, 5] put on the stack".
//   before   the stack that was handed in
Words next_child_words(const StackState *before, const NextChildAnswer *answer);

// "ends the search" or "goes on with node 9 and [3, 6], 2 waiting".
Words next_waiting_words(const NextWaitingAnswer *answer);

#endif
