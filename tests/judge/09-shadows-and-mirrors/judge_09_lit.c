// Lab 09: which lights arrive at a point: rolled and judged.
#include "judge_09_lights.h"

#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Rolling ------------------------------------------------------------------------------------

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

// How many of the lights may be before the surface: one ray for each is enough. The tree is that
// of a scene whose rays are counted, one leaf: the leaves visited are the rays sent.
static OracleSides light_sides(const Job09 *job, int i)
{
    const LitJob *in = &job->lits[i];
    return oracle3d_sides(job->lit_lights + in->first_light, in->n_lights,
                          oracle3d_exactly(in->point), oracle3d_exactly(in->normal));
}

// Is any ray sent where one is certainly needed, as no light here is black? Where none is, lights
// that arrive are found in another way, or `work` was not passed on.
static int is_any_sent(const Job09 *job, int i, u32 n_rays)
{
    const OracleSides sides = light_sides(job, i);
    return n_rays > 0 || sides.n_before == sides.n_unsure;
}

// Are as many rays sent as by a mistake with them alone, or as is right? That is judged in the
// second range.
static int sends_as(const Job09 *job, int i, u32 n_rays, int number)
{
    const u32 n_needed = light_sides(job, i).n_before;
    switch (number) {
    case LIT_ASKS_ALL:
        return n_rays == (u32)job->lits[i].n_lights;
    case LIT_ASKS_TWICE:
        return n_rays >= n_needed && (n_rays == 0 || n_needed > 0);
    case LIT_UNCOUNTED:
        return n_rays == 0;
    default:
        return i / N_LIT_INPUTS != 1 || (n_rays <= n_needed && is_any_sent(job, i, n_rays));
    }
}

static int lit_agrees(const void *pointer, int i, const void *answers, int number)
{
    const LitAnswer *found = (const LitAnswer *)answers + i;
    const LitMistake *mistake = &lit_mistakes_09[number];
    const LitJob *in = &((const Job09 *)pointer)->lits[i];
    const OracleNear expected =
        mistake->sum == NULL ? right_light(pointer, i) : lights_09_mistaken(pointer, in, mistake);
    // A mistake of the sum is known by its colours: rays may be sent or not.
    return (lit_09_counts_only(i) || oracle3d_is_near(found->color, expected)) &&
           (mistake->sum != NULL || sends_as(pointer, i, found->n_leaves, number));
}

// Of some input more rays are sent than it has lights: then one light is asked twice.
static int is_any_asked_twice(const Job09 *job, Range range, const LitAnswer *found)
{
    int i = 0;
    while (i < range.n &&
           found[range_at(range, i)].n_leaves <= (u32)job->lits[range_at(range, i)].n_lights) {
        i++;
    }
    return i < range.n;
}

// A mistake of the sum is known by a wrong colour: where only the work is wrong, it is no cause.
static int lit_shows(const void *job, Range range, const void *answers, int mistake)
{
    if (mistake == LIT_ASKS_TWICE) {
        return is_any_asked_twice(job, range, answers);
    }
    int n_wrong = 0;
    for (int i = 0; i < range.n; i++) {
        const int input = range_at(range, i);
        const LitAnswer *found = (const LitAnswer *)answers + input;
        n_wrong +=
            !lit_09_counts_only(input) && !oracle3d_is_near(found->color, right_light(job, input));
    }
    return lit_mistakes_09[mistake].sum == NULL || n_wrong > 0;
}

static char *describe_lit(const void *pointer, int i, const void *answers)
{
    const Job09 *job = pointer;
    const LitJob *in = &job->lits[i];
    const LitAnswer *found = (const LitAnswer *)answers + i;
    const OracleVector e = right_light(job, i).value;
    const u32 n_needed = light_sides(job, i).n_before;
    if (!sends_as(job, i, found->n_leaves, 0)) {
        return message_new("point %s, normal %s, %d light%s, %s before the surface: found %u ray%s "
                           "sent to lights, expected %s: one for each light before the surface, "
                           "and none for a light behind",
                           words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text,
                           in->n_lights, plural((unsigned)in->n_lights),
                           n_needed == 0 ? "none" : words("%u", n_needed).text, found->n_leaves,
                           plural(found->n_leaves),
                           n_needed == 0          ? "none"
                           : found->n_leaves == 0 ? words("%u", n_needed).text
                                                  : words("at most %u", n_needed).text);
    }
    return message_new("point %s, normal %s, %d light%s, the first at %s: found %s, expected %s",
                       words_vec3(in->point, 6).text, words_vec3(in->normal, 6).text, in->n_lights,
                       plural((unsigned)in->n_lights),
                       words_vec3(job->lit_lights[in->first_light].position, 6).text,
                       words_vec3(found->color, 5).text, words_xyz(e.x, e.y, e.z, 5).text);
}

const Function lit_09 = {"lits", N_LITS, sizeof(LitAnswer),
                         COMPARED(lit_agrees, describe_lit, lit_mistakes_09), .shows = lit_shows};
