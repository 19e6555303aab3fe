// What lab 01's judge asks of a submission: inputs of overlaps_N_Nearer (judge_01_inputs.c), judged
// in judge_01_overlaps.c, and scenes (judge_01.c).
#ifndef JUDGE_JUDGE_01_H
#define JUDGE_JUDGE_01_H

#include "job_scene.h"
#include "jobs_01.h"
#include "judge.h"

// The scenes, in the order of the job; each check looks at a range of them. No picture has a pixel
// that neither the first nor the second has.
enum {
    WIDE = 0,    // columns do not fit in 8 bits
    HIGH = 1,    // rows do not
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

enum { WIDE_COLUMNS = 317, WIDE_ROWS = 100, HIGH_COLUMNS = 48, HIGH_ROWS = 272 };
enum { N_PIXELS = WIDE_COLUMNS * WIDE_ROWS + HIGH_COLUMNS * (HIGH_ROWS - WIDE_ROWS) };

// How many inputs each of the three function checks tries, one range after the other: some are
// rolled, and some are what the kernel sends in a picture, so that who is wrong in a picture is
// wrong here, too.
enum { N_ROLLED_INSIDE = 3000, N_ROLLED_BOUNDARY = 1000, N_ROLLED_NEARER = 1000 };
enum { N_SENT_INSIDE = 100, N_SENT_BOUNDARY = 20, N_SENT_NEARER = 40 };  // by each scene
enum { N_INSIDE = N_ROLLED_INSIDE + 2 * N_PIXELS + N_SENT_INSIDE * N_SCENES };
enum { N_BOUNDARY = N_ROLLED_BOUNDARY + N_SENT_BOUNDARY * N_SCENES };
enum { N_NEARER = N_ROLLED_NEARER + N_SENT_NEARER * N_SCENES };
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
void roll_overlaps_01(Random *random, const JobScene scenes[N_SCENES], OverlapJob jobs[N_OVERLAPS]);

extern const Function overlaps_01;

#endif
