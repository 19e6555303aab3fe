// The scenes of lab 10's job: random ones, the edge cases, a sphereflake, and a view so wide that a
// tile is a large part of it.
#include "judge_10.h"

#include "complain.h"
#include "job_scene3d_tree.h"
#include "job_sections.h"

#include <stdlib.h>
#include <string.h>

// A random scene: every nth sphere is seen from inside only; from 0 on, the eye is at the middle.
typedef struct RandomPlan {
    int n_spheres;
    float min_radius, max_radius;
    int width, height;
    KdTreeLimits limits;
    int every_negative;
    float angle;  // 0: as it is rolled, from outside
} RandomPlan;

static const RandomPlan plans[N_RANDOM] = {
    // Few levels and one tile first: a message is then short to follow.
    {12, 0.125f, 0.375f, 8, 8, {2, 1}, 0, 0},
    {40, 0.125f, 0.25f, 24, 16, {4, 2}, 0, 0},
    {100, 0.0625f, 0.25f, 49, 37, {8, 3}, 0, 0},
    {200, 0.03125f, 0.125f, 64, 48, {12, 4}, 0, 90},
    {400, 0.015625f, 0.0625f, 64, 48, {15, 2}, 0, 0},
    {80, 0.0625f, 0.375f, 49, 33, {10, 2}, 3, 70},
    {60, 0.125f, 0.375f, 16, 12, {9, 2}, 0, 160},
    {1500, 0.015625f, 0.0625f, 96, 64, {17, 6}, 0, 0},
};

static int roll_random(Random *random, const RandomPlan *plan, JobScene3D *scene)
{
    if (job_scene3d_random(scene, random, plan->n_spheres, plan->min_radius, plan->max_radius,
                           plan->width, plan->height) != 0) {
        return -1;
    }
    Scene3D *s = &scene->scene;
    for (int i = 0; plan->every_negative > 0 && i < plan->n_spheres; i += plan->every_negative) {
        s->spheres[i].radius *= -1;
    }
    while (plan->angle > 0 && s->view.angle != plan->angle) {
        s->view.from.x = random_grid(random, -8, 8) / 16;
        s->view.from.y = random_grid(random, -8, 8) / 16;
        s->view.from.z = random_grid(random, -8, 8) / 16;
        s->view.angle = plan->angle;
        if (scene3d_view_fault(&s->view) != NULL) {
            s->view.angle = 0;
        }
    }
    job_scene3d_aim(scene);
    return job_scene3d_grow_tree(scene, plan->limits);
}

static const struct {
    const char *name;
    int width, height;
    KdTreeLimits limits;
} edges[N_EDGES] = {
    {"inside", 48, 36, {9, 2}},
    {"planes", 65, 49, {10, 2}},
    {"one-cell", 40, 32, {30, 4}},
    {"none", 16, 16, {9, 1}},
    {"coincident", 48, 36, {9, 4}},
    {"large-small", 64, 48, {12, 4}},
    {"behind", 48, 36, {12, 1}},
    {"lattice:n=4", 64, 48, {10, 1}},
    {"sphereflake:size=3", 96, 72, {14, 6}},
};

int roll_scenes_10(Random *random, JobScene3D scenes[N_SCENES])
{
    int result = 0;
    for (int i = 0; result == 0 && i < N_RANDOM; i++) {
        result = roll_random(random, &plans[i], &scenes[RANDOM + i]);
    }
    for (int i = 0; result == 0 && i < N_EDGES; i++) {
        JobScene3D *scene = &scenes[EDGES + i];
        result = job_scene3d_named(scene, random, edges[i].name, edges[i].width, edges[i].height);
        if (result == 0) {
            result = job_scene3d_grow_tree(scene, edges[i].limits);
        }
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene3d_expect(&scenes[k]);
    }
    return result;
}

int scene_10_write(const JobScene3D *scene, int k, FILE *file)
{
    const KdTree3D *tree = &scene->tree;
    Sphere *leaf_spheres = malloc((tree->n_sphere_ids + 1) * sizeof *leaf_spheres);
    if (leaf_spheres == NULL) {
        complain("grade: no memory for %u spheres", tree->n_sphere_ids);
        return -1;
    }
    for (u32 i = 0; i < tree->n_sphere_ids; i++) {
        leaf_spheres[i] = scene->scene.spheres[tree->sphere_ids[i]];
    }
    const int result = job_scene3d_write(scene, k, file) |
                       job_section_write(file, k, "leaf_spheres", leaf_spheres,
                                         tree->n_sphere_ids * sizeof *leaf_spheres);
    free(leaf_spheres);
    return result;
}
