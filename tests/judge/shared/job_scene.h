// A scene of a job: what the probe draws or builds, and what should come out.
#ifndef JUDGE_JOB_SCENE_H
#define JUDGE_JOB_SCENE_H

#include "job_picture.h"
#include "random.h"
#include "scene2d.h"
#include "scene_kind.h"
#include "tree2d.h"

typedef struct JobScene {
    Scene2D scene;        // circles and the picture's size
    KdTreeLimits limits;  // of its tree
    KdTree2D tree;        // lab 02: what is expected; lab 03: what the kernel searches
    JobPicture picture;
} JobScene;

// A random scene with circles of 2 to max_radius pixels. Returns 0, or -1 after one message.
int job_scene_random(JobScene *scene, Random *random, int n_circles, int max_radius, int width,
                     int height);

// A scene of scene2d.h by name, varied by the seed (scene_vary.h): sides of width and height or a
// few pixels less, in any order. Returns 0, or -1 after one message.
int job_scene_named(JobScene *scene, Random *random, const char *name, int width, int height);

// Spread the depths of a random scene from about -500 000 to 500 000: a depth may be any number.
void job_scene_spread_depths(JobScene *scene);

// Let the first circle of a random scene be the nearest, and lie before the second: then what is
// wrong with the first alone is seen.
void job_scene_cover_second(JobScene *scene);

// Depths of every size: the largest float, two that are one float apart, both zeros; and circles
// that are black or transparent before others. Where they are is rolled. Returns 0, or -1 after one
// message.
int job_scene_depths(JobScene *scene, Random *random);

// More circles than 16 bits count, all of them over all pixels: the last one is seen. Returns 0, or
// -1 after one message.
int job_scene_pile(JobScene *scene, Random *random);

// Let the oracle draw what is expected. Returns 0, or -1 after one message.
int job_scene_expect(JobScene *scene);

// Write the sections "scene.K" ...; the tree's too when there is one, and behind its lists the id
// of the circle that must not be asked. Returns 0, or -1.
int job_scene_write(const JobScene *scene, int k, FILE *file);

// Write "scene.K.circles" alone, and behind the circles one that must not be asked. Returns 0, or
// -1.
int job_scene_write_circles(const JobScene *scene, int k, FILE *file);

void job_scene_free(JobScene *scene);

// The two above, as judges have it.
extern const SceneKind job_scene_kind;

// Let wrong pictures of a scene be recognised. The scene must stay where it is. job_scene_expect()
// does it.
void job_scene_recognise(const JobScene *scene, ExpectedPicture *expected);

// The same mistakes where circles are squares: beside the stub of lab 01's overlaps_N_Nearer.
// As DrawMistaken has it.
Cause job_scene_draw_squares(const void *scene, int mistake, Image *guess, float *tolerances);

#endif
