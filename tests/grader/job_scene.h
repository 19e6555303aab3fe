// A scene of a job: what the probe draws or builds, and what should come out.
#ifndef GRADER_JOB_SCENE_H
#define GRADER_JOB_SCENE_H

#include "judge.h"
#include "kdtree2d_build.h"
#include "picture.h"
#include "random.h"
#include "scene2d.h"

typedef struct JobScene {
    char title[96];       // "random scene"
    Scene2D scene;        // circles and the picture's size
    KdTreeLimits limits;  // of its tree
    KdTree2D tree;        // lab 03: what the kernel searches
    ExpectedPicture expected;
} JobScene;

// A random scene with circles of 2 to max_radius pixels. Returns 0, or -1 after one message.
int job_scene_random(JobScene *scene, Random *random, int n_circles, int max_radius, int width,
                     int height);

// A scene of scene2d.h by name. Returns 0, or -1 after one message.
int job_scene_named(JobScene *scene, const char *name, int width, int height);

// Spread the depths of a random scene from about -500 000 to 500 000: a depth may be any number.
void job_scene_spread_depths(JobScene *scene);

// Let the oracle draw what is expected. Returns 0, or -1 after one message.
int job_scene_expect(JobScene *scene);

// Build the scene's tree with the solution of lab 02. Returns 0, or -1 after one message.
int job_scene_grow_tree(JobScene *scene, KdTreeLimits limits);

// Write the sections "scene.K" ...; the tree's too when there is one. Returns 0, or -1.
int job_scene_write(const JobScene *scene, int k, FILE *file);

void job_scene_free(JobScene *scene);

// The probe's answer "picture.K", pixels NULL when it is missing.
ProbeImage job_scene_answer(const JobScene *scene, int k, const Sections *answers);

// Judge the probe's picture of scene K.
Verdict job_scene_judge(const JobScene *scene, int k, const Sections *answers);

// The same for scenes first to first + n - 1: the first wrong one decides.
Verdict job_scenes_judge(const JobScene *scenes, int first, int n, const Sections *answers);

// Judge that nothing was written outside the pictures of n scenes.
Verdict job_scenes_judge_padding(const JobScene *scenes, int n, const Sections *answers);

// Compare with the solution's picture from now on.
void job_scene_adopt(JobScene *scene, int k, const Sections *answers);

// Add scene K to the report's pictures, if there is room.
void job_scene_add_picture(const JobScene *scene, int k, const Sections *answers, Result *result);

// Add n scenes, the wrong ones first.
void job_scenes_add_pictures(const JobScene *scenes, int n, const Sections *answers,
                             Result *result);

#endif
