// What lab 05's judge asks of a submission: inputs of its functions and whole scenes, and what an
// answer is tried on alone. Read next: judge_05.c, judge_05_alone.c.
#ifndef GRADER_JUDGE_05_H
#define GRADER_JUDGE_05_H

#include "job_scene3d.h"
#include "jobs.h"
#include "judge.h"
#include "judge_05_inputs.h"
#include "random.h"

// The checks, in the order of the report.
enum {
    ROOT_NEARER,
    ROOT_INSIDE,
    ROOT_T_MIN,
    TEXTBOOK_OUTSIDE,
    TEXTBOOK_INSIDE,
    SPHERE_NEAR,
    SPHERE_INSIDE,
    SPHERE_FAR_SMALL,
    HIT_NEAREST,
    HIT_TIES,
    HIT_EDGES,
    HIT_WORK,
    NORMAL_UNIT,
    NORMAL_INSIDE,
    SHADE_LAMBERT,
    SHADE_BEHIND,
    SHADE_LIGHTS,
    SHADE_PICTURE,
};

// The scenes, in the order of the job.
enum {
    RANDOM = 0,  // two
    FLAKE = 2,
    TIES = 3,
    EDGES = 4,
    N_EDGES = 5,
    N_SCENES = EDGES + N_EDGES,
    WORK = RANDOM + 1,
};

// ---- Alone: nearest_hit ---------------------------------------------------------------------

// Scenes whose spheres are squares for the stand-in of intersect_sphere. They have the numbers of
// the scenes above that they are there for.
enum { MAX_SQUARES = 160 };
typedef struct SquareScene {
    int n, width, height;
    Sphere squares[MAX_SQUARES + 1];  // behind the last one that must not be asked
} SquareScene;

void squares_05_draw(Random *random, SquareScene scenes[N_SCENES]);

// Write the sections "scene.K" and "scene.K.spheres". Returns 0, or -1.
int squares_05_write(const SquareScene scenes[N_SCENES], FILE *file);

// Are all hits of scenes first to first + n - 1 right? Was every square of the scene WORK asked
// once by every ray?
int squares_05_pass_hits(const SquareScene scenes[N_SCENES], int first, int n,
                         const Sections *answers);
int squares_05_pass_work(const SquareScene scenes[N_SCENES], const Sections *answers);

// ---- The job ----------------------------------------------------------------------------------

typedef struct Job05 {
    Inputs05 inputs;
    JobScene3D scenes[N_SCENES];
    JobPicture *pictures[N_SCENES];  // the scenes'
    SquareScene squares[N_SCENES];
} Job05;

// See judge, write_alone and passes_alone of judge.h.
Verdict judge_05_check(const void *job, int check, const Sections *answers);
int alone_05_write(const void *job, const char *task, FILE *file);
int alone_05_passes(const void *job, int check, const Sections *answers);

#endif
