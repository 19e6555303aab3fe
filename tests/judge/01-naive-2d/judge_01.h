// What lab 01's judge asks of a submission: inputs of overlaps_N_Nearer (judge_01_inputs.c), judged
// in judge_01_overlaps.c, and scenes (judge_01.c).
#ifndef JUDGE_JUDGE_01_H
#define JUDGE_JUDGE_01_H

#include "job_scene.h"
#include "jobs_01.h"
#include "judge.h"

// The scenes, in the order of the job; each check looks at a range of them.
enum {
    WIDE = 0,    // 317x211
    HIGH = 1,    // 48x272: rows do not fit in 8 bits
    RANDOM = 2,  // two more
    ORDER = 4,
    EDGES = 5,
    NONE = EDGES,
    DEPTHS = EDGES + 1,  // before the rest, as in most of that the first circle is the nearest
    NAMED = EDGES + 2,
    PILE = EDGES + 7,
    N_EDGES = 8,
    N_SCENES = EDGES + N_EDGES,
};

// How many inputs each of the three function checks tries, one range after the other.
enum { N_INSIDE = 3000, N_BOUNDARY = 1000, N_NEARER = 1000 };
enum { N_OVERLAPS = N_INSIDE + N_BOUNDARY + N_NEARER };

typedef struct Job01 {
    Job job;
    OverlapJob overlaps[N_OVERLAPS];
    JobScene scenes[N_SCENES];
} Job01;

// What is less is near a boundary, and all that an epsilon is meant for.
#define SMALL 0.125

// How far the pixel is outside the circle, in squares: 0 on the boundary, less inside.
double outside_by_01(OverlapJob in);

// Roll the inputs: the ranges one after the other.
void roll_overlaps_01(Random *random, OverlapJob jobs[N_OVERLAPS]);

extern const Function overlaps_01;

#endif
