// What lab 03's judge asks of a submission: inputs of getContainingChild, and scenes with their
// trees. Drawn in judge_03_job.c, judged in judge_03.c; answers are tried alone in
// judge_03_alone.c.
#ifndef JUDGE_JUDGE_03_H
#define JUDGE_JUDGE_03_H

#include "job_scene.h"
#include "jobs.h"
#include "judge.h"

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
    Job job;
    ChildJob children[N_CHILDREN];
    JobScene scenes[N_SCENES];
} Job03;

// See judge.h.
int job_03_draw(void *job, Random *random);
void job_03_release(void *job);
int job_03_write_scene(const void *job, int k, FILE *file);

// One answer alone.
int write_alone_03(const void *job, const char *task, FILE *file);
int ends_in_leaves_03(const void *job, int k, const Sections *answers);
int all_end_in_leaves_03(const void *job, const JudgeCheck *check, const Sections *answers);

// Is the point in the cell? Cells are half-open: minX <= x < maxX.
int cell_holds(BBox2D box, double x, double y);

// The leaf whose cell holds the point, found by asking all of them; the number of nodes when none
// does.
u32 leaf_at(const KdTree2D *tree, int x, int y);

#endif
