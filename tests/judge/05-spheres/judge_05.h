// What lab 05's judge asks of a submission: inputs of its functions and whole scenes, and what an
// answer is tried on alone. Inputs are rolled in judge_05_inputs.c, or are what pictures send
// (judge_05_sent.c), and those of every job stand in judge_05_edges.c; functions are judged in
// judge_05_roots.c and judge_05_shading.c, one answer alone in judge_05_alone.c, nearest_hit in
// judge_05_squares.c.
#ifndef JUDGE_JUDGE_05_H
#define JUDGE_JUDGE_05_H

#include "job_scene3d.h"
#include "jobs_05.h"
#include "judge.h"

// How many inputs of each range are at most what whole pictures send: the first ones.
enum { N_SENT_ROOTS = 1000, N_SENT_SPHERES = 500, N_SENT_NORMALS = 500 };

// How many inputs each range has; the ranges of one function follow one another.
enum {
    N_ROOTS = N_SENT_ROOTS + 600,      // 3 ranges: outside, inside, t_min
    N_SPHERES = N_SENT_SPHERES + 800,  // 3: outside, inside, small and far; the textbook has two
    N_NORMALS = N_SENT_NORMALS + 500,  // 2: outside, inside
    N_SHADES = 300,  // 3 ranges: one light before the surface, one behind it too, several
    N_LIGHTS = 320,
};

// The last inputs of a range are the same in every job.
enum {
    N_EDGE_ROOTS = 15,    // of each range
    N_EDGE_SPHERES = 19,  // outside and inside
    N_EDGE_NORMALS = 12,  // of each range
    N_EDGE_SHADES = 10,   // several lights
    N_SHADES_OF_ONE = 3,  // one light
    N_EDGE_LIGHTS = 7,    // the last ones
};

// The scenes, in the order of the job. The first one shows what is wrong at any size.
enum {
    RANDOM = 0,
    SMALL = 1,  // another random one, a millionth as large
    LARGE = 2,  // a sphereflake, a trillion times as large
    MANY = 3,   // shells, and before them in the array N_BEHIND spheres that nobody sees
    TIES = 4,
    EDGES = 5,
    N_EDGES = 5,
    N_SCENES = EDGES + N_EDGES,
    // Where work is counted: SMALL; TIES, with spheres like others; and "behind".
    WORK_STEP = TIES - SMALL,
    N_WORK = 3,
};

// More than 16 bits count.
enum { N_BEHIND = 1 << 16 };

// Alone, nearest_hit is tried on scenes whose spheres are squares for the stub of
// intersect_sphere. They have the numbers of the scenes above that they are there for.
enum { MAX_SQUARES = 160 };
typedef struct SquareScene {
    int n_behind;  // before those in the array, not kept here
    int n, width, height;
    Sphere squares[MAX_SQUARES + 1];  // behind the last one that must not be asked
} SquareScene;

// What one of the intersections gets: roots or spheres, and in which form a right solution may be.
typedef struct Inputs05 {
    const RootJob *roots;
    const SphereRayJob *spheres;
    OracleForm form;
    // What stands in the hole of nearest_root where the answers are those of one task alone.
    double (*root)(double b, double disc, double radius, double t_min, u32 nonce);
    u32 nonce;
} Inputs05;

typedef struct Job05 {
    Job job;
    RootJob roots[3 * N_ROOTS];
    SphereRayJob textbook[2 * N_SPHERES];
    SphereRayJob projection[3 * N_SPHERES];
    NormalJob normals[2 * N_NORMALS];
    ShadeJob shades[3 * N_SHADES];
    Light lights[N_LIGHTS];
    JobScene3D scenes[N_SCENES];
    SquareScene squares[N_SCENES];
    Inputs05 of_root, of_textbook, of_sphere;  // each in this job
} Job05;

// Roll what the functions get; put the inputs of every job into their places.
void roll_inputs_05(Job05 *job, Random *random);
void inputs_05_set_edges(Job05 *job);
void inputs_05_add_sent(Job05 *job, Random *random);
void inputs_05_link(Job05 *job);

// Does the ray, along z, touch the sphere and all of that in numbers that float holds? Then every
// right form finds a disc of exactly 0, and b for the hit.
int touches_exactly_05(const SphereRayJob *job);

// The functions. The message about one names the mistake that explains every answer in the range.
extern const Function nearest_root_05, textbook_05, projection_05, normal_05, shade_05;

// The same two beside the stub of nearest_root: only what is handed to that is known.
extern const Function textbook_alone_05, projection_alone_05;

// ---- Alone --------------------------------------------------------------------------------------

void roll_squares_05(Random *random, SquareScene scenes[N_SCENES]);

// Write the sections "scene.K" and "scene.K.spheres". Returns 0, or -1.
int squares_05_write(const SquareScene scenes[N_SCENES], FILE *file);

// Are all hits of scene K right? Was every square of it asked once by every ray?
int square_hits_05(const void *job, int k, const Sections *answers);
int square_work_05(const void *job, int k, const Sections *answers);

// See judge.h.
int write_alone_05(const void *job, const char *task, FILE *file);
int spheres_alone_05(const void *job, const JudgeCheck *check, const Sections *answers);
int pixel_shades_05(const void *job, const JudgeCheck *check, const Sections *answers);
Cause spheres_cause_05(const void *job, const JudgeCheck *check, const Sections *answers);
Cause squares_cause_05(const void *job, const JudgeCheck *check, const Sections *answers);

#endif
