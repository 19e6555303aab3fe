// Lab 09: each answer alone, beside stubs where it calls another task's function (see
// tests/stubs/README.md).
//
// leave_surface, mirrored_direction, shadow_ray and leaf_blocks need no other task. lit_color is
// tried on points and lights of a grid, where a ray goes along the axis on which the light is
// farthest and a nonce says what blocks it; ray_color on the scenes of the whole job, where mirrors
// send every ray almost along the normal and surfaces shine by themselves. How exactly only who
// calls the stubs is told.
#include "judge_09.h"

#include "alone_picture.h"
#include "job_sections.h"
#include "random3d.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const OracleRules3D right = {0};

// ---- lit_color ----------------------------------------------------------------------------------

// The lights of input i begin here.
static int first_light(int i)
{
    return i * (MOST_ALONE_LIGHTS + 1);
}

// A whole number of sixteenths.
static float sixteenths(Random *random, int lowest, int highest)
{
    return (float)random_integer(random, lowest, highest) / 16;
}

// Light number i, farthest along an axis: nowhere else half as far.
static Light roll_light(Random *random, Vec3 point, int axis, int sign, int i)
{
    const float distance = (float)sign * sixteenths(random, 16, 96);
    Vec3 position = along_09(axis, distance);
    const float aside = sixteenths(random, -7, 7), up = sixteenths(random, -7, 7);
    const Vec3 a = along_09((axis + 1) % 3, aside), b = along_09((axis + 2) % 3, up);
    position = (Vec3){point.x + position.x + a.x + b.x, point.y + position.y + a.y + b.y,
                      point.z + position.z + a.z + b.z};
    return (Light){position, light_09_color(random, i)};
}

// In the second range all lights are behind the surface, but for one input in four.
static void roll_input(Random *random, Job09 *job, int i)
{
    const int axis = i % 3, side = random_sign(random), range = i / N_LIT_INPUTS;
    const int is_mixed = range == 2 || lit_09_counts_only(i);
    LitJob *lit = &job->alone_lits[i];
    *lit =
        (LitJob){.normal = along_09(axis, (float)side),
                 .first_light = first_light(i),
                 .n_lights = range == 0        ? 1
                             : i == N_LITS - 1 ? MANY_ALONE_LIGHTS
                                               : (i32)random_integer(random, 2, MOST_ALONE_LIGHTS),
                 .bounds = {{-100, -100, -100}, {100, 100, 100}}};
    lit->point = (Vec3){sixteenths(random, -64, 64), sixteenths(random, -64, 64),
                        sixteenths(random, -64, 64)};
    lit->material.color = random_vector(random, 0.25, 1);
    lit->material.kd = random_number(random, 0.125, 0.875);
    lit->material.ks = 1 - lit->material.kd;
    const int n_drawn = i == N_LITS - 1 ? MANY_ALONE_LIGHTS : MOST_ALONE_LIGHTS;
    for (int k = 0; k <= n_drawn; k++) {
        const int is_behind =
            is_mixed ? random_integer(random, 0, 2) == 0 : range == 1 && i % 4 != 0;
        job->alone_lights[first_light(i) + k] =
            roll_light(random, lit->point, axis, is_behind ? -side : side, i + k);
    }
}

void roll_alone_09(Random *random, Job09 *job)
{
    for (int i = 0; i < N_LITS; i++) {
        roll_input(random, job, i);
    }
    for (int k = 0; k < N_PLACED_LITS; k++) {
        LitJob *lit = &job->alone_lits[lit_09_placed(k)];
        lit_09_place(lit, &job->alone_lights[lit->first_light], k);
    }
}

// A tree of one leaf.
static int write_lits(const Job09 *job, FILE *file)
{
    const Sphere sphere = {0, 0, 0, 1};
    const KdNode3 leaf = {0, KD_LEAF, 0, 1};
    const u32 id = 0;
    return section_write(file, "lits", job->alone_lits, sizeof job->alone_lits) |
           section_write(file, "lit_lights", job->alone_lights, sizeof job->alone_lights) |
           job_section_write(file, LIT_SCENE, "spheres", &sphere, sizeof sphere) |
           job_section_write(file, LIT_SCENE, "nodes", &leaf, sizeof leaf) |
           job_section_write(file, LIT_SCENE, "sphere_ids", &id, sizeof id);
}

// What the stub of leaf_blocks says, with what it knows on the device under the same names.
typedef unsigned int uint;
static int is_blocked_by_chance(ShadowRayAnswer ray, uint NONCE)
{
#include "09-shadows-and-mirrors/leaf_blocks.cl"
}

// A number's sign where it is the largest, else 0.
static float sign_of_largest(float x, float largest)
{
    return fabsf(x) != largest ? 0 : copysignf(1, x);
}

// The ray of the stub of shadow_ray.
static ShadowRayAnswer ray_along_axis(Vec3 point, Vec3 way, uint nonce)
{
    const float largest = fmaxf(fmaxf(fabsf(way.x), fabsf(way.y)), fabsf(way.z));
    const float length = (float)(1 + nonce / 4096 % 15) / 16;
    return (ShadowRayAnswer){.origin = point,
                             .direction = {length * sign_of_largest(way.x, largest),
                                           length * sign_of_largest(way.y, largest),
                                           length * sign_of_largest(way.z, largest)},
                             .t_max = largest + (float)(nonce / 64 % 64) / 16};
}

int is_blocked_alone_09(Vec3 point, Vec3 way, u32 nonce)
{
    return is_blocked_by_chance(ray_along_axis(point, way, nonce), nonce);
}

static int is_right_light(const Job09 *job, int i, const LitAnswer *found)
{
    const LitJob *in = &job->alone_lits[i];
    OracleNear sum = {{0}, 0};
    int n_before = 0;
    for (int k = 0; k < in->n_lights; k++) {
        const Light *light = &job->alone_lights[in->first_light + k];
        const Vec3 way = vec3_minus(light->position, in->point);
        const OracleNear share =
            oracle3d_shade(oracle3d_exactly(in->point), oracle3d_exactly(in->normal), &in->material,
                           light, 1, &right);
        const int is_before = vec3_dot(in->normal, way) > 0;
        n_before += is_before;
        if (is_before && !is_blocked_alone_09(in->point, way, job->job.nonce)) {
            sum.value.x += share.value.x;
            sum.value.y += share.value.y;
            sum.value.z += share.value.z;
            sum.error += share.error + 0x1p-22;
        }
    }
    // The tree is one leaf around all: each ray that is sent asks it once. Who knows the nonce and
    // sends none sees only as many lights as arrive.
    return (lit_09_counts_only(i) || oracle3d_is_near(found->color, sum)) &&
           found->n_leaves == (u32)n_before;
}

int lits_alone_09(const void *job, const JudgeCheck *check, const Sections *answers)
{
    const LitAnswer *found = function_answers(check->function, answers);
    int i = check->range.first;
    const int end = i + check->range.n;
    while (found != NULL && i < end && is_right_light(job, i, &found[i])) {
        i++;
    }
    return i == end;
}

// ---- ray_color ----------------------------------------------------------------------------------

int picture_alone_09(const void *job, int k, const Sections *answers)
{
    ExpectedPicture expected = {0};
    int passes = picture_09_expect_alone(job, k, &expected) == 0;
    if (passes) {
        const Image *reference = &expected.reference;
        const ProbeImage own = probe_image_find(answers, k, reference->width, reference->height);
        passes = own.pixels != NULL && picture_is_right(own, &expected);
    }
    expected_picture_free(&expected);
    return passes;
}

Cause picture_cause_09(const void *job, const JudgeCheck *check, const Sections *answers)
{
    return alone_pictures_look(job, check->range.first, check->range.n, picture_09_expect_alone,
                               answers);
}

static int write_pictures(const Job09 *job, FILE *file)
{
    int result = 0;
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = scene_09_write(&job->scenes[k], k, file);
    }
    return result;
}

// ---- All ----------------------------------------------------------------------------------------

int write_alone_09(const void *job, const char *task, FILE *file)
{
    return strcmp(task, "lit_color") == 0   ? write_lits(job, file)
           : strcmp(task, "ray_color") == 0 ? write_pictures(job, file)
                                            : 0;
}
