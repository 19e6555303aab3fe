// What lab 03's judge asks of a submission: inputs of getContainingChild, and scenes with their
// trees. Drawn in judge_03_job.c, judged in judge_03.c; answers are tried alone in
// judge_03_alone.c.
#ifndef GRADER_JUDGE_03_H
#define GRADER_JUDGE_03_H

#include "job_scene.h"
#include "jobs.h"
#include "judge.h"

#include <stdint.h>
#include <stdio.h>

// The checks, in the order of the report.
enum {
    CHILD_INSIDE,
    CHILD_BORDER,
    DESCENT_PICTURE,
    DESCENT_LEAF,
    DESCENT_WORK,
    LEAF_RANDOM,
    LEAF_ORDER,
    LEAF_EDGES,
    LEAF_WORK,
};

// The scenes.
enum {
    BORDERS = 0,  // root [0, 256] x [0, 256]: splits fall on whole pixels
    WIDE = 1,
    LEAF_MAP = 2,  // each leaf has a colour of its own
    RANDOM = 3,    // two
    ORDER = 5,
    EDGES = 6,
    ROOT_IS_LEAF = EDGES + 4,
    N_EDGES = 6,
    N_SCENES = EDGES + N_EDGES,
};
enum { N_INSIDE = 2000, N_BORDER = 1000 };
enum { N_CHILDREN = N_INSIDE + N_BORDER };

typedef struct Job03 {
    ChildJob children[N_CHILDREN];
    JobScene scenes[N_SCENES];
    JobPicture *pictures[N_SCENES];  // the scenes'
} Job03;

// See job_new and job_free of judge.h.
void *job_03_new(uint64_t seed, FILE *file);
void job_03_free(void *job);

// See judge, write_alone and passes_alone of judge.h.
Verdict judge_03_check(const void *job, int check, const Sections *answers);
int alone_03_write(const void *job, const char *task, FILE *file);
int alone_03_passes(const void *job, int check, const Sections *answers);

// Is the point in the cell? Cells are half-open: minX <= x < maxX.
int cell_holds(BBox2D box, double x, double y);

// The leaf whose cell holds the point, found by asking all of them; the number of nodes when none
// does.
u32 leaf_at(const KdTree2D *tree, int x, int y);

#endif
