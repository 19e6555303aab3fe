// One pixel, followed: what its own kernel does for it, what the reference does, and where the two
// part. In words, as JSON and as a picture.
//
// Read next: pixel.c, record.h.
#ifndef FOLLOW_FOLLOWED_H
#define FOLLOW_FOLLOWED_H

#include "steps/steps.h"
#include "world.h"

#include <stdio.h>

typedef struct Followed {
    const World *world;
    int x, y;                 // the pixel
    Steps own;                // what the lab's kernel does
    Steps reference;          // what a right one does; n_steps is 0 where there is no reference
    int parting;              // the first step in which they differ; -1: there is none
    int is_close;             // before that step rounding decides: both may be right
    const char *naive_label;  // of an earlier lab's kernel, which asks every element, or NULL
    Step naive_end;           // what that one ends with
} Followed;

// Follow a pixel of the world. Kernels are those of the world's lab.
// Returns 0, or -1 after messages on stderr: a kernel does not build.
int followed_make(Followed *followed, const World *world, const WorldLab *world_lab, int x, int y);

// Where is a step's number: a step behind the last one, which has none, is NULL.
const Step *followed_step(const Steps *steps, u32 i);

// The todo stack at a step, the nearest on top: waiting[0] is the lowest. A student's may hold
// anything; what was never written down is a node NO_ID.
// Returns how many there are, at most TODO_SIZE.
u32 followed_waiting(const Steps *steps, u32 i, StepWaiting waiting[TODO_SIZE]);

// Is the element that was asked a hit: sphere met, or circle nearest so far?
int followed_is_hit(const World *world, const Step *step);

// A step in words, as followed_print() says it: how many lines it takes at most, and how long they
// are. No line where there is no such step.
enum { STEP_LINES = 3, STEP_LINE_BYTES = 160 };
typedef struct StepWords {
    char lines[STEP_LINES][STEP_LINE_BYTES];
    int n;
} StepWords;
StepWords followed_words(const World *world, const Steps *steps, u32 i);

// Say it in words: the steps that both take one below the other, then side by side.
void followed_print(const Followed *followed, FILE *file);

// Write it as JSON; as a picture, SVG. Returns 0, or -1 after one message on stderr.
int followed_save_json(const Followed *followed, const char *path);
int followed_save_svg(const Followed *followed, const char *path);

#endif
