// The inputs of lab 05's functions that stand in every job: see judge_05.h.
//
// Each is there for a mistake that rolled inputs show by chance or not at all: limits and epsilons
// where none belong, and cases that have to meet. They end their ranges, so that a message names
// a rolled input where one is wrong, too.
#include "judge_05.h"

#include <string.h>

// ---- nearest_root -------------------------------------------------------------------------------

static const RootJob edge_roots[3][N_EDGE_ROOTS] = {
    // b, disc, radius, t_min
    {
        {1, -0x1p-30f, 1, 0},  // near misses
        {8, -0x1p-12f, 1, 0},
        {0x1p10f, -0x1p-30f, 1, 0},
        {1, 0, 1, 0},  // touching, and short chords
        {0x1p-20f, 0, 0x1p-22f, 0},
        {0x1p100f, 0, 0x1p60f, 0},
        {1, 0x1p-30f, 1, 0},
        {0x1p-20f, 0x1p-44f, 0x1p-22f, 0},  // close to the eye
        {0x1p-10f, 0x1p-24f, 0x1p-12f, 0},
        {0x1p-40f, 0x1p-84f, 0x1p-42f, 0},
        {0x1p20f, 0x1p30f, 0x1p15f, 0},  // far away
        {0x1p40f, 0x1p70f, 0x1p35f, 0},
        {0x1p63f, 0x1p116f, 0x1p58f, 0},
        {5, 4, 3, 0},
        {5, 4, 3, 2},
    },
    {
        {1, 4, 3, 0},  // the eye inside, the centre ahead,
        {1, 4, -3, 0},
        {-1, 4, 3, 0},  // and behind
        {-1, 4, -3, 0},
        {-1, 4, 3, 0.5f},  // and t_min inside, too
        {-1, 4, -3, 0.5f},
        {0, 4, 3, 0},  // the eye at the centre
        {0, 4, -3, 0},
        {-5, 4, 3, 0},  // all of it behind
        {-5, 4, -3, 0},
        {5, 4, -3, 0},  // all of it ahead
        {-0x1p-22f, 0x1p-40f, 0x1p-20f, 0},
        {-0x1p-22f, 0x1p-40f, -0x1p-20f, 0},
        {0x1p-20f, 0x1p-44f, -0x1p-22f, 0},
        {0x1p20f, 0x1p30f, -0x1p15f, 0},
    },
    {
        {5, 4, 3, 8},  // t_min beyond the roots, before them and between them
        {5, 4, -3, 1},
        {5, 4, -3, 4},
        {5, 4, -3, 8},
        {1, 4, -3, 4},
        {5, 4, 3, 6},  // between the middle and the exit
        {5, 4, -3, 6},
        {1, 0, 3, 0.5f},  // touching beyond t_min, at it, and as closely beyond it as can be
        {1, 0, 3, 1},
        {1, 0, -3, 1},
        {1, 0, 3, 0x1.fffffep-1f},
        {1, 0, -3, 0x1.fffffep-1f},
        {1, 0, 3, 0x1.000002p+0f},                        // and as closely before it
        {1, 0x1p-20f, 0x1p-9f, 1 - 0x1p-10f - 0x1p-20f},  // an entry close beyond t_min
        {0x1p-10f, 0x1p-40f, 0x1p-9f, 0x1p-10f - 0x1p-20f - 0x1p-30f},
    },
};

// ---- intersect_textbook, intersect_sphere -------------------------------------------------------

// A sphere, seen from the eye, and the ray's t_min. The ray goes along z, from the origin.
typedef struct EdgeSphere {
    Sphere sphere;
    float t_min;
} EdgeSphere;

// Of each range the last ones lie as far as that from the origin, and the ray is aslant. Steps of
// float are 1/8 there: what is added to such a number, or multiplied with it, loses digits.
#define AFAR 0x1p20f
enum { FIRST_AFAR = N_EDGE_SPHERES - 2 };

static const EdgeSphere edge_spheres[2][N_EDGE_SPHERES] = {
    {
        {{0x1p-23f, 0, 0x1p-20f, 0x1p-22f}, 0},  // close to the eye
        {{0x1p-13f, 0, 0x1p-10f, 0x1p-12f}, 0},
        {{0x1p17f, 0, 0x1p20f, 0x1p18f}, 0},  // far away
        {{0x1p37f, 0, 0x1p40f, 0x1p38f}, 0},
        {{0.5f - 0x1p-12f, 0, 2, 0.5f}, 0},  // nearly missed, and
        {{0.5f + 0x1p-12f, 0, 2, 0.5f}, 0},  // missed by little
        {{0, 0.25f, 3, -1}, 0},
        {{3, 0, 4, 3}, 0},  // touched, the centre at a distance that float holds,
        {{0, 2, 4, 2}, 1},  // and at one that it rounds
        {{0, 0, 4, 2}, 0},  // met in its middle
        {{0, 0.25f, 3, 1}, 0},
        {{0, 0.25f, 3, 1}, 1},  // beyond t_min, all of it
        {{0x1p-9f, 0, 3, 0x1p-8f}, 2.96875f},
        {{1, 1, 20, 4}, 12},
        {{0, 0.25f, 5, 1}, 3.5f},
        {{0x1p-13f, 0, 0x1p-10f, 0x1p-12f}, 0x1p-11f},
        {{0x1p17f, 0, 0x1p20f, 0x1p18f}, 0x1p19f},
        {{6.25f, 1, 8, 2}, 0},  // afar
        {{-0.5f, 7, 8.5f, 3}, 0},
    },
    {
        {{0.5f, 0, -1, 3}, 0},                             // the eye inside, the centre behind
        {{0.5f, 0, -1, -3}, 0},    {{0.5f, 0, -1, 3}, 1},  // and t_min inside, too
        {{0.5f, 0, -1, -3}, 1},    {{0.5f, 0, -1, 3}, 4},  // or beyond
        {{0.5f, 0, 1, 3}, 2},  // the eye inside, the centre ahead, but before t_min
        {{0.5f, 0, 1, -3}, 2},     {{0, 0.5f, -5, -1}, 0},  // all of it behind
        {{0, 0.5f, 5, 1}, 5},  // t_min between the roots: at the middle,
        {{0, 0.5f, 5, -1}, 5},     {{0, 0.5f, 5, 1}, 4.5f},  // before it
        {{0, 0.5f, 5, 1}, 5.5f},                             // and behind it
        {{0, 0.5f, 5, -1}, 5.5f},  {{0, 0.5f, 5, 1}, 8},     // beyond them
        {{0, 0.5f, 1, 2}, 4},      {{0, 0.5f, 5, -1}, 1},    // and before them
        {{3, 0, 4, -3}, 0},                                  // touched
        {{1, 0.5f, -0.25f, 3}, 0},                           // afar
        {{0.5f, -1, 1, -4}, 0},
    },
};

static void set_edge_spheres(SphereRayJob *jobs, const EdgeSphere *edges)
{
    for (int i = 0; i < N_EDGE_SPHERES; i++) {
        jobs[i] = (SphereRayJob){
            .sphere = edges[i].sphere, .direction = {0, 0, 1}, .t_min = edges[i].t_min};
        if (i >= FIRST_AFAR) {
            jobs[i].origin = (Vec3){AFAR, -AFAR, AFAR};
            jobs[i].direction = (Vec3){0.6f, 0, 0.8f};
            jobs[i].sphere.x += AFAR, jobs[i].sphere.y -= AFAR, jobs[i].sphere.z += AFAR;
        }
    }
}

// ---- surface_normal -----------------------------------------------------------------------------

enum { N_GRAZED_NORMALS = 4 };

// Rays that graze the surface, to the bit: the cosine is nearly the least of which a right solution
// is sure to find the sign (oracle3d_normal()).
static NormalJob grazed_normal(int range, int i)
{
    const float cosine = range == 0 ? -0x1p-20f : 0x1p-20f, radius = i < 2 ? 2 : -2;
    NormalJob job = {.sphere = {1, 2, 3, radius}, .point = {1, 2, 3}};
    if (i % 2 == 0) {
        job.point.x += 2, job.direction = (Vec3){cosine, 1, 0};
    } else {
        job.point.z -= 2, job.direction = (Vec3){0, 1, -cosine};
    }
    return job;
}

static NormalJob edge_normal(int range, int i)
{
    static const NormalJob others[N_EDGE_NORMALS - N_GRAZED_NORMALS] = {
        // Around the origin and along an axis the dot product is one product, and exact however
        // small. The last ray of these is a tangent.
        {{0, 0, 0, 2}, {2, 0, 0}, {-0x1p-40f, 1, 0}},
        {{0, 0, 0, -2}, {0, -2, 0}, {0, 0x1p-40f, -1}},
        {{0, 0, 0, 2}, {0, 0, 2}, {1, 0, 0}},
        // Spheres so small that their vectors are short, or so large that they are long; and of
        // which, away from the origin, float rounds the point: it is not as far from the centre as
        // the radius says.
        {{0, 0, 0, 0x1p-40f}, {0, 0x1p-40f, 0}, {0.6f, -0.8f, 0}},
        {{0, 0, 0, 0x1p40f}, {0, 0, 0x1p40f}, {0.6f, 0, -0.8f}},
        {{0.5f, 0, 0, 0x1p-12f}, {0.5f + 0x1p-12f, 0, 0}, {-1, 0, 0}},
        {{96, 0, 0, 0x1.8p-17f}, {96 + 0x1p-17f, 0x1p-17f, 0}, {-0.8f, 0, 0.6f}},
        {{0, 96, -96, 0x1.8p-16f}, {0, 96 + 0x1p-16f, -96 - 0x1p-17f}, {0.6f, 0, 0.8f}},
    };
    if (i < N_GRAZED_NORMALS) {
        return grazed_normal(range, i);
    }
    NormalJob job = others[i - N_GRAZED_NORMALS];
    job.direction = range == 1 ? vec3_scaled(job.direction, -1) : job.direction;
    return job;
}

// ---- shade --------------------------------------------------------------------------------------

// The last lights of all.
enum {
    BRIGHT_LIGHT = N_LIGHTS - N_EDGE_LIGHTS,  // at the zenith, one of them black, two the same
    N_BRIGHT_LIGHTS = 4,
    LOW_LIGHT = BRIGHT_LIGHT + N_BRIGHT_LIGHTS,
    NEAR_LIGHT,  // and behind it one that must not shine
};

static void set_edge_lights(Light lights[N_LIGHTS])
{
    const Vec3 white = {1, 1, 1}, zenith = {0, 0, 4};
    Light *bright = &lights[BRIGHT_LIGHT];
    bright[0] = (Light){zenith, {4, 2, 0.5f}};
    bright[1] = (Light){{0, 0, 5}, {0, 0, 0}};
    bright[2] = bright[3] = (Light){{0, 0, 6}, white};
    lights[LOW_LIGHT] = (Light){{1024, 0, 0x1p-6f}, white};
    lights[NEAR_LIGHT] = (Light){{0, 0, 0x1p-20f}, white};
    lights[NEAR_LIGHT + 1] = (Light){zenith, white};
}

// Of n lights the last one stands straight above the surface; of none, the one that must not
// shine.
static ShadeJob shade_of_many(int n_lights, const Light lights[N_LIGHTS])
{
    const int above = n_lights > 0 ? n_lights - 1 : 0;
    return (ShadeJob){.normal = vec3_normalized(lights[above].position),
                      .material = {.color = {1, 0.5f, 0.25f}, .kd = 0.5f},
                      .n_lights = n_lights};
}

static ShadeJob shade_on_the_ground(int first_light, int n_lights)
{
    return (ShadeJob){.normal = {0, 0, 1},
                      .material = {.color = {1, 0.75f, 0.5f}, .kd = 1},
                      .first_light = first_light,
                      .n_lights = n_lights};
}

static void set_edge_shades(Job05 *job)
{
    static const int n_lights[N_EDGE_SHADES - 1] = {0, 6, 9, 11, 17, 33, 65, 129, 300};
    ShadeJob *one_light = &job->shades[N_SHADES - N_SHADES_OF_ONE];
    ShadeJob *several = &job->shades[3 * N_SHADES - N_EDGE_SHADES];
    set_edge_lights(job->lights);
    one_light[0] = shade_on_the_ground(LOW_LIGHT, 1);
    one_light[1] = shade_on_the_ground(NEAR_LIGHT, 1);
    // A surface may give back more than it gets.
    one_light[2] = shade_on_the_ground(BRIGHT_LIGHT, 1);
    one_light[2].material = (Material){.color = {2, 1.5f, 0.5f}, .kd = 1.5f};
    for (int i = 0; i < N_EDGE_SHADES - 1; i++) {
        several[i] = shade_of_many(n_lights[i], job->lights);
    }
    several[N_EDGE_SHADES - 1] = shade_on_the_ground(BRIGHT_LIGHT, N_BRIGHT_LIGHTS);
}

// ---- All ----------------------------------------------------------------------------------------

void inputs_05_set_edges(Job05 *job)
{
    for (int range = 0; range < 3; range++) {
        memcpy(&job->roots[(range + 1) * N_ROOTS - N_EDGE_ROOTS], edge_roots[range],
               sizeof edge_roots[range]);
    }
    for (int range = 0; range < 2; range++) {
        const int first = (range + 1) * N_SPHERES - N_EDGE_SPHERES;
        set_edge_spheres(&job->textbook[first], edge_spheres[range]);
        set_edge_spheres(&job->projection[first], edge_spheres[range]);
        for (int i = 0; i < N_EDGE_NORMALS; i++) {
            job->normals[(range + 1) * N_NORMALS - N_EDGE_NORMALS + i] = edge_normal(range, i);
        }
    }
    set_edge_shades(job);
}
