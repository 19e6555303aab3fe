// Lab 09: points and lights for lit_color, which is judged in judge_09_lights.c.
#include "judge_09.h"

#include "random3d.h"

#include <math.h>

Vec3 along_09(int axis, float x)
{
    return (Vec3){axis == 0 ? x : 0, axis == 1 ? x : 0, axis == 2 ? x : 0};
}

Vec3 light_09_color(Random *random, int i)
{
    return i % 5 == 0 ? along_09(i / 5 % 3, 1) : random_vector(random, 0.125, 1);
}

// Lights all over the scene: before and behind its spheres, and some in them.
static void roll_lights(Random *random, Light lights[N_LIT_LIGHTS])
{
    for (int i = 0; i < N_LIT_LIGHTS; i++) {
        const double reach = i % 3 == 0 ? 4 : 1.5;
        lights[i].position = random_point(random, reach);
        lights[i].color = light_09_color(random, i);
    }
}

// A point beside a sphere of the scene, far enough that it is no part of it.
static void roll_point(Random *random, const Scene3D *scene, LitJob *job)
{
    const Sphere sphere = scene->spheres[random_integer(random, 0, scene->n_spheres - 1)];
    const float distance = 1.0625f * fabsf(sphere.radius);
    job->normal = random_direction(random);
    job->point = (Vec3){sphere.x + distance * job->normal.x, sphere.y + distance * job->normal.y,
                        sphere.z + distance * job->normal.z};
}

// How many of a job's lights are before the surface?
static int count_before(const LitJob *job, const Light *lights)
{
    int n = 0;
    for (int k = 0; k < job->n_lights; k++) {
        n += vec3_dot(job->normal, vec3_minus(lights[k].position, job->point)) > 0;
    }
    return n;
}

// How many lights the last inputs of the last range have. The last light is before the surface and
// above it, and bright.
static const i32 edge_lights[N_EDGE_LITS] = {0, 6, 9, 17, 33, 65, 129, MOST_LIT_LIGHTS};

static void set_edge(const Light *lights, LitJob *job, i32 n_lights)
{
    job->n_lights = n_lights;
    job->first_light = 0;
    job->material.kd = 2;
    if (n_lights == edge_lights[N_EDGE_LITS - 1]) {
        // Beside the scene, where most of the many lights arrive: their sum is far beyond 1.
        job->point = (Vec3){0, 0, 6};
    }
    if (n_lights > 0) {
        job->normal = vec3_normalized(vec3_minus(lights[n_lights - 1].position, job->point));
    }
}

int lit_09_placed(int k)
{
    return k < N_GRAZING_LITS ? 2 * N_LIT_INPUTS - 1 - k : N_LIT_INPUTS - 1 - (k - N_GRAZING_LITS);
}

int lit_09_counts_only(int i)
{
    return i / N_LIT_INPUTS == 1 && i % 4 == 1 && i < lit_09_placed(N_GRAZING_LITS - 1);
}

void lit_09_place(LitJob *job, Light *light, int k)
{
    // By how little they graze, twice from before and twice from behind.
    static const float cosines[N_GRAZING_LITS] = {0x1p-12f, 0x1p-17f, -0x1p-12f, -0x1p-17f};
    const int axis = k % 3;
    job->n_lights = 1;
    light->position = vec3_minus(job->point, along_09(axis, -4));
    light->color = (Vec3){1, 0.5f, 0.25f};
    if (k < N_GRAZING_LITS) {
        job->material.kd = 1;
        job->normal = vec3_minus(along_09((axis + 1) % 3, 1), along_09(axis, -cosines[k]));
        light->color = vec3_scaled(light->color, 1 / fabsf(cosines[k]));
    } else {
        const int is_dark = k == N_GRAZING_LITS;
        job->normal = along_09(axis, 1);
        job->material.kd = is_dark ? 1 / DIM : DIM;
        light->color = vec3_scaled(light->color, is_dark ? DIM : 1 / DIM);
    }
}

// Beside the scene, where nothing stands between.
static void place_light(Job09 *job, int k)
{
    LitJob *lit = &job->lits[lit_09_placed(k)];
    lit->first_light = N_DRAWN_LIGHTS + k;
    lit->point = (Vec3){0, 0, 6};
    lit_09_place(lit, &job->lit_lights[lit->first_light], k);
}

// One light before the surface; all of them behind it; several, on either side. Of the second kind
// one in four has its light before it: who adds no light at all is not right there. One more in
// four has several lights on either side, and only the rays are judged.
static LitJob roll_lit(Random *random, int i, const JobScene3D *scene, const Light *lights)
{
    const int range = i / N_LIT_INPUTS;
    const int is_lit = range == 0 || (range == 1 && i % 4 == 0);
    const int is_dark = range == 1 && !is_lit && !lit_09_counts_only(i);
    LitJob job = {.bounds = scene->tree.bounds};
    job.material.color = random_vector(random, 0.25, 1);
    job.material.kd = random_number(random, 0.125, 0.875);
    job.material.ks = random_number(random, 0, 1);
    do {
        roll_point(random, &scene->scene, &job);
        job.n_lights = is_lit ? 1 : (i32)random_integer(random, is_dark ? 1 : 2, 5);
        job.first_light = (i32)random_integer(random, 0, N_DRAWN_LIGHTS - 6);
    } while ((is_lit && count_before(&job, lights + job.first_light) != 1) ||
             (is_dark && count_before(&job, lights + job.first_light) != 0));
    return job;
}

void roll_lits_09(Random *random, Job09 *job)
{
    roll_lights(random, job->lit_lights);
    for (int i = 0; i < COUNT(job->lits); i++) {
        job->lits[i] = roll_lit(random, i, &job->scenes[LIT_SCENE].base, job->lit_lights);
    }
    for (int i = 0; i < N_EDGE_LITS; i++) {
        set_edge(job->lit_lights, &job->lits[N_LITS - N_EDGE_LITS + i], edge_lights[i]);
    }
    for (int k = 0; k < N_PLACED_LITS; k++) {
        place_light(job, k);
    }
}
