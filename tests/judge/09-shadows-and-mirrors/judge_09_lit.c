// Lab 09: which lights arrive at a point: drawn and judged.
#include "judge_09_lights.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Drawing ------------------------------------------------------------------------------------

// Lights all over the scene: before and behind its spheres, and some in them.
static void draw_lights(Random *random, Light lights[N_LIT_LIGHTS])
{
    for (int i = 0; i < N_LIT_LIGHTS; i++) {
        const double reach = i % 3 == 0 ? 4 : 1.5;
        lights[i].position = random_point(random, reach);
        lights[i].color = random_vector(random, 0.125, 1);
    }
}

// A point beside a sphere of the scene, far enough that it is no part of it.
static void draw_point(Random *random, const Scene3D *scene, LitJob *job)
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

static Vec3 along(int axis, float x)
{
    return (Vec3){axis == 0 ? x : 0, axis == 1 ? x : 0, axis == 2 ? x : 0};
}

void lit_09_set_grazing(LitJob *job, Light *light, int k, int axis)
{
    const float cosine = k == 0 ? 0x1p-12f : 0x1p-17f;
    job->n_lights = 1;
    job->material.kd = 1;
    job->normal = vec3_minus(along((axis + 1) % 3, 1), along(axis, -cosine));
    light->position = vec3_minus(job->point, along(axis, -4));
    light->color = vec3_scaled((Vec3){1, 0.5f, 0.25f}, 1 / cosine);
}

// Beside the scene, where nothing stands between.
static void set_grazing(Job09 *job, int k)
{
    LitJob *lit = &job->lits[2 * N_LIT_INPUTS - 1 - k];
    lit->first_light = N_DRAWN_LIGHTS + k;
    lit->point = (Vec3){0, 0, 6};
    lit_09_set_grazing(lit, &job->lit_lights[lit->first_light], k, k);
}

// One light before the surface; all of them behind it; several, on either side. Of the second kind
// one in four has its light before it: who adds no light at all is not right there.
static LitJob draw_lit(Random *random, int i, const JobScene3D *scene, const Light *lights)
{
    const int range = i / N_LIT_INPUTS, is_dark = range == 1 && i % 4 != 0;
    const int is_lit = range == 0 || (range == 1 && !is_dark);
    LitJob job = {.bounds = scene->tree.bounds};
    job.material.color = random_vector(random, 0.25, 1);
    job.material.kd = random_number(random, 0.125, 0.875);
    job.material.ks = random_number(random, 0, 1);
    do {
        draw_point(random, &scene->scene, &job);
        job.n_lights = is_lit ? 1 : (i32)random_integer(random, is_dark ? 1 : 2, 5);
        job.first_light = (i32)random_integer(random, 0, N_DRAWN_LIGHTS - 6);
    } while ((is_lit && count_before(&job, lights + job.first_light) != 1) ||
             (is_dark && count_before(&job, lights + job.first_light) != 0));
    return job;
}

void lits_09_draw(Random *random, Job09 *job)
{
    draw_lights(random, job->lit_lights);
    for (int i = 0; i < COUNT(job->lits); i++) {
        job->lits[i] = draw_lit(random, i, &job->scenes[LIT_SCENE].base, job->lit_lights);
    }
    for (int i = 0; i < N_EDGE_LITS; i++) {
        set_edge(job->lit_lights, &job->lits[N_LITS - N_EDGE_LITS + i], edge_lights[i]);
    }
    for (int k = 0; k < N_GRAZING_LITS; k++) {
        set_grazing(job, k);
    }
}

// ---- Judging ------------------------------------------------------------------------------------

static OracleNear right_light(const Job09 *job, int i)
{
    static const OracleMirrorRules right = {0};
    const LitJob *in = &job->lits[i];
    Scene3D scene = job->scenes[LIT_SCENE].base.scene;
    scene.lights = (Light *)(job->lit_lights + in->first_light);
    scene.n_lights = in->n_lights;
    return oracle3d_lit(&scene, oracle3d_exactly(in->point), oracle3d_exactly(in->normal),
                        &in->material, NULL, &right);
}

// Are all lights behind the surface? Then no ray is needed.
static int is_behind(const Job09 *job, int i)
{
    return i / N_LIT_INPUTS == 1 &&
           count_before(&job->lits[i], job->lit_lights + job->lits[i].first_light) == 0;
}

// Where a ray from the point to any light visits a leaf: in the tree's bounds.
static int is_in_bounds(const LitJob *in)
{
    const float at[3] = {in->point.x, in->point.y, in->point.z};
    int is_inside = 1;
    for (int axis = 0; axis < 3; axis++) {
        is_inside &= at[axis] > in->bounds.min[axis] && at[axis] < in->bounds.max[axis];
    }
    return is_inside;
}

static int lit_agrees(const void *pointer, int i, const void *answers, int number)
{
    const LitAnswer *found = (const LitAnswer *)answers + i;
    const LitMistake *mistake = &lit_mistakes_09[number];
    const LitJob *in = &((const Job09 *)pointer)->lits[i];
    const OracleNear expected =
        mistake->sum == NULL ? right_light(pointer, i) : lights_09_mistaken(pointer, in, mistake);
    const int is_spared = !is_behind(pointer, i) || found->n_leaves == 0;
    const int is_sent = !is_behind(pointer, i) || found->n_leaves > 0 || !is_in_bounds(in);
    // A mistake of the sum is known by its colours: rays may be sent or not.
    return oracle3d_is_near(found->color, expected) &&
           (mistake->sum != NULL || (number == 0 ? is_spared : is_sent));
}

// A mistake of the sum is known by a wrong colour: where only the work is wrong, it is no cause.
static int lit_shows(const void *job, Range range, const void *answers, int mistake)
{
    int n_wrong = 0;
    for (int i = 0; i < range.n; i++) {
        const int input = range_at(range, i);
        const LitAnswer *found = (const LitAnswer *)answers + input;
        n_wrong += !oracle3d_is_near(found->color, right_light(job, input));
    }
    return lit_mistakes_09[mistake].sum == NULL || n_wrong > 0;
}

static char *describe_lit(const void *pointer, int i, const void *answers)
{
    const Job09 *job = pointer;
    const LitJob *in = &job->lits[i];
    const LitAnswer *found = (const LitAnswer *)answers + i;
    const OracleVector e = right_light(job, i).value;
    if (is_behind(job, i) && found->n_leaves > 0) {
        return message_new("point %s, normal %s, %d light%s, all behind the surface: found %u "
                           "leaves visited, expected none: no ray is needed for them",
                           words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text,
                           in->n_lights, plural((unsigned)in->n_lights), found->n_leaves);
    }
    return message_new("point %s, normal %s, %d light%s, the first at %s: found %s, expected %s",
                       words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->n_lights,
                       plural((unsigned)in->n_lights),
                       words_vec3(job->lit_lights[in->first_light].position, 6).text,
                       words_vec3(found->color, 5).text, words_xyz(e.x, e.y, e.z, 5).text);
}

const Function lit_09 = {"lits", N_LITS, sizeof(LitAnswer),
                         COMPARED(lit_agrees, describe_lit, lit_mistakes_09), .shows = lit_shows};
