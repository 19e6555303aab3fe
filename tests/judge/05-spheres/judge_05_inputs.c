// Rolling the inputs of lab 05's functions: see judge_05.h.
#include "judge_05.h"

#include "random3d.h"

#include <math.h>

static Vec3 vec3_plus(Vec3 a, Vec3 b)
{
    return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

// A unit vector at right angles to v.
static Vec3 across(Random *random, Vec3 v)
{
    Vec3 w;
    do {
        w = vec3_cross(v, random_direction(random));
    } while (vec3_dot(w, w) < 0.125f);
    return vec3_normalized(w);
}

// A chord's half is a number in steps of 1/16, and so are the roots: they are exact.
static RootJob roll_root(Random *random, int range)
{
    const float half_chord = (float)random_integer(random, 1, 160) / 16;
    const float gap = (float)random_integer(random, 1, 160) / 16;
    RootJob job = {.disc = half_chord * half_chord, .radius = half_chord + 1};
    job.b = half_chord + gap;
    const int kind = (int)random_integer(random, 0, 3);
    if (random_integer(random, 0, 3) == 0) {
        return job;  // in every range, some inputs are plain
    }
    if (range == 0 && kind == 0) {
        job.disc = -gap;  // a miss
    } else if (range == 0 && kind == 1) {
        job.disc = 0;  // the two roots are one
    } else if (range == 1 && kind == 0) {
        job.radius = -job.radius;  // the eye outside, and only the far side is there
    } else if (range == 1 && kind == 1) {
        job.b = -gap - half_chord;  // the sphere behind the eye
    } else if (range == 1) {
        job.b = half_chord * (float)random_integer(random, -15, 15) / 16;  // around it
        job.radius = kind == 2 ? -job.radius : job.radius;
    } else if (range == 2) {
        // Before the sphere, in it, behind it; exactly where it is only touched.
        job.t_min = kind == 0 ? gap / 2 : kind == 1 ? gap + half_chord : job.b + half_chord + gap;
        if (kind == 3) {
            job.disc = 0;
            job.t_min = job.b;
        }
    }
    return job;
}

// How far a sphere is, seen from the eye, and how large. A sphere of radius 1 far away differs from
// the textbook's point of view only by size; near ones are harmless.
typedef struct Distances {
    double nearest, farthest;
    double smallest, largest;  // radius over distance
} Distances;

static SphereRayJob roll_sphere(Random *random, int range)
{
    static const Distances outside = {2, 8, 0.2, 0.8}, inside = {0.5, 4, 1.25, 3},
                           small = {200, 400, 0.00005, 0.0002};
    // Some of the spheres around the eye are before it after all.
    const int is_inside = range == 1 && random_integer(random, 0, 3) != 0;
    const Distances d = range == 2 ? small : is_inside ? inside : outside;
    SphereRayJob job = {.origin = random_point(random, 4)};
    job.direction = random_direction(random);
    const float distance = random_number(random, d.nearest, d.farthest);
    const float radius =
        distance * (float)(d.smallest + (d.largest - d.smallest) *
                                            (double)random_integer(random, 0, 1024) / 1024);
    // The line passes the centre at up to 1.5 radii; small spheres are mostly hit.
    const float miss = radius * random_number(random, 0, range == 2 ? 1.05 : 1.5);
    const Vec3 aside = vec3_scaled(across(random, job.direction), miss);
    const int is_behind = is_inside && random_integer(random, 0, 3) == 0;
    const float along =
        is_behind ? -distance - radius : sqrtf(fmaxf(distance * distance - miss * miss, 0));
    Vec3 centre = vec3_plus(vec3_plus(job.origin, aside), vec3_scaled(job.direction, along));
    job.sphere = (Sphere){centre.x, centre.y, centre.z, radius};
    if (range == 1 && random_integer(random, 0, 3) == 0) {
        job.sphere.radius = -radius;
    }
    return job;
}

static NormalJob roll_normal(Random *random, int range)
{
    NormalJob job = {0};
    const Vec3 centre = random_vector(random, -3, 3);
    const float radius = random_number(random, 0.25, 4);
    job.sphere = (Sphere){centre.x, centre.y, centre.z, radius};
    const Vec3 outwards = random_direction(random);
    job.point = vec3_plus(centre, vec3_scaled(outwards, job.sphere.radius));
    do {
        job.direction = random_direction(random);
    } while (fabsf(vec3_dot(outwards, job.direction)) < 0.0625f);
    const int is_from_inside = range == 1 && random_integer(random, 0, 3) != 0;
    if ((vec3_dot(outwards, job.direction) > 0) != is_from_inside) {
        job.direction = vec3_scaled(job.direction, -1);
    }
    job.sphere.radius *= is_from_inside && random_integer(random, 0, 1) ? -1 : 1;
    return job;
}

static ShadeJob roll_shade(Random *random, int range, const Light lights[N_LIGHTS])
{
    ShadeJob job = {.point = random_point(random, 2), .n_lights = 1};
    job.normal = random_direction(random);
    job.material = (Material){.shine = 30, .refraction = 1};
    job.material.color = random_vector(random, 0.25, 1);
    job.material.kd = random_number(random, 0.125, 0.875);
    job.material.ks = random_number(random, 0, 1);
    job.first_light = (i32)random_integer(random, 0, N_LIGHTS - N_EDGE_LIGHTS - 6);
    const Vec3 way = vec3_minus(lights[job.first_light].position, job.point);
    if (range == 2) {
        job.n_lights = (i32)random_integer(random, 1, 5);
    } else if (vec3_dot(job.normal, way) < 0) {
        job.normal = vec3_scaled(job.normal, -1);
    }
    if (range == 1) {
        // The second light is behind the surface.
        job.n_lights = 2;
        const Light second = lights[job.first_light + 1];
        const Vec3 towards = vec3_normalized(vec3_minus(second.position, job.point));
        job.normal = vec3_normalized(vec3_minus(vec3_normalized(way), towards));
    }
    return job;
}

void roll_inputs_05(Job05 *job, Random *random)
{
    for (int i = 0; i < N_LIGHTS; i++) {
        // Outside the cube where points are.
        const float distance = random_number(random, 4, 12);
        const Vec3 position = vec3_scaled(random_direction(random), distance);
        job->lights[i] = (Light){position, random_vector(random, 0.125, 1)};
    }
    for (int i = 0; i < COUNT(job->roots); i++) {
        job->roots[i] = roll_root(random, i / N_ROOTS);
    }
    for (int i = 0; i < COUNT(job->textbook); i++) {
        job->textbook[i] = roll_sphere(random, i / N_SPHERES);
    }
    for (int i = 0; i < COUNT(job->projection); i++) {
        job->projection[i] = roll_sphere(random, i / N_SPHERES);
    }
    for (int i = 0; i < COUNT(job->normals); i++) {
        job->normals[i] = roll_normal(random, i / N_NORMALS);
    }
    for (int i = 0; i < COUNT(job->shades); i++) {
        job->shades[i] = roll_shade(random, i / N_SHADES, job->lights);
    }
}

void inputs_05_link(Job05 *job)
{
    job->of_root = (Inputs05){.roots = job->roots};
    job->of_textbook = (Inputs05){.spheres = job->textbook, .form = ORACLE_TEXTBOOK};
    job->of_sphere = (Inputs05){.spheres = job->projection, .form = ORACLE_PROJECTION};
}
