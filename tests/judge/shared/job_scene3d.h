// A 3D scene of a job: what the probe traces, and what should come out. The sibling of job_scene.h.
//
// Behind the end of each of the scene's arrays stands one entry more, which must not be asked: a
// sphere nearest of all, its material, and a garish light.
#ifndef JUDGE_JOB_SCENE3D_H
#define JUDGE_JOB_SCENE3D_H

#include "job_picture.h"
#include "jobs.h"
#include "oracle3d.h"
#include "random.h"
#include "scene3d.h"
#include "scene_kind.h"
#include "tree3d.h"

typedef struct JobScene3D {
    Scene3D scene;        // with its view and the picture's size
    Camera camera;        // for that view and size, by lab 04's solution: what kernels get
    KdTreeLimits limits;  // of its tree
    KdTree3D tree;        // lab 07: what the kernel searches
    OracleHit *hits;      // [height * width], what each pixel's ray hits
    JobPicture picture;
} JobScene3D;

// A random scene with radii of min_radius to max_radius in the cube [-1, 1]^3, seen from anywhere
// around it; materials and lights of all colours. Returns 0, or -1 after one message.
int job_scene3d_random(JobScene3D *scene, Random *random, int n_spheres, float min_radius,
                       float max_radius, int width, int height);

// A scene of scene3d.h by name, varied by the seed (scene_vary.h): sides of width and height or a
// few pixels less. Returns 0, or -1 after one message.
int job_scene3d_named(JobScene3D *scene, Random *random, const char *name, int width, int height);

// Make a scene `factor` times as large, a power of two: its picture stays as it is.
//   words   what the title says of that: "a millionth as large"
void job_scene3d_scale(JobScene3D *scene, float factor, const char *words);

// Set up the camera anew after the scene's view has been changed. All functions above do it.
void job_scene3d_aim(JobScene3D *scene);

// Let the oracle trace what is expected: hits and picture. Returns 0, or -1 after one message.
int job_scene3d_expect(JobScene3D *scene);

// The ray of a pixel.
OracleRay job_scene3d_ray(const JobScene3D *scene, int pixel);

// Write the sections "scene.K" ...; the tree's too when there is one. Returns 0, or -1.
int job_scene3d_write(const JobScene3D *scene, int k, FILE *file);

void job_scene3d_free(JobScene3D *scene);

// The two above, as judges have it.
extern const SceneKind job_scene3d_kind;

// ---- Hits ---------------------------------------------------------------------------------------

// The answer "hits.K", [height * width], or NULL when it is missing.
const HitAnswer *hits_find(const JobScene3D *scene, int k, const Sections *answers);

// Is it what the oracle says? Where rounding decides anything is.
int hit_is_right(const OracleHit *expected, HitAnswer found);

// What is wrong with a scene's hits: the first wrong ray, how many there are, and the mistake that
// explains all of them, if one does. Owned by the caller.
Diagnosis hits_judge(const JobScene3D *scene, const HitAnswer *found);

// The same where it is known what they look like, if anything.
Diagnosis hits_judge_as(const JobScene3D *scene, const HitAnswer *found, Cause looks);

// Are they those by these rules, where rounding decides nothing?
int hits_follow(const JobScene3D *scene, const HitAnswer *found, const OracleRules3D *rules);

// Number i of the known mistakes of hits, and the rules by which the oracle makes it. Nothing
// behind the last.
Cause hit_mistake(int i, OracleRules3D *rules);

// How many rays of a scene are wrong.
int hits_count_wrong(const JobScene3D *scene, const HitAnswer *found);

#endif
