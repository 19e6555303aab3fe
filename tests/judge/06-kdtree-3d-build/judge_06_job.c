// Rolling lab 06's job from the seed: see judge_06.h.
//
// The functions' inputs are on coarse grids, so that no right answer depends on rounding: squared
// distances are whole numbers of grid squares below 2^24, which float holds exactly.
//
// Behind those that are rolled stand the edges, which no seed may miss: inputs that show a rare
// mistake. They come last, so that any other mistake is shown without them. Double holds all that
// they lead to exactly.
#include "judge_06.h"

#include "overlap_reach.h"
#include "packed_list.h"
#include "random3d.h"
#include "scene_vary.h"

static Sphere sphere_at(const float centre[3], float radius)
{
    return (Sphere){centre[0], centre[1], centre[2], radius};
}

// A sphere with its centre in the box from lowest to highest.
static Sphere roll_sphere(Random *random, const int lowest[3], const int highest[3], int max_radius)
{
    float centre[3];
    for (int axis = 0; axis < 3; axis++) {
        centre[axis] = random_eighth(random, lowest[axis], highest[axis]);
    }
    return sphere_at(centre, random_eighth(random, 1, max_radius));
}

static BBox3D roll_cell(Random *random)
{
    BBox3D cell;
    for (int axis = 0; axis < 3; axis++) {
        cell.min[axis] = random_eighth(random, -50, 40);
        cell.max[axis] = cell.min[axis] + random_eighth(random, 1, 40);
    }
    return cell;
}

// ---- Inputs of the functions --------------------------------------------------------------------

// The next float above 1 is 1 + STEP.
#define STEP 0x1p-23f

// Sides that are nearly equal: by a step of float, and by next to nothing in small cells; or all of
// no length.
static const BBox3D nearly_cubes[] = {
    {{0, 0, 0}, {1, 1 + 0x1p-12f, 1}},
    {{0, 0, 0}, {1, 1, 1 + 0x1p-12f}},
    {{0, 0, 0}, {1 + 0x1p-12f, 1 + 0x1p-11f, 1}},
    {{0, 0, 0}, {1, 1 + STEP, 1}},
    {{0, 0, 0}, {1, 1, 1 + STEP}},
    {{0, 0, -4096 - 0x1p-11f}, {4096, 4096, 0}},
    {{0, 0, 0}, {0x1p-20f, 0x1p-20f + 0x1p-30f, 0x1p-20f}},
    {{0, 0, 0}, {0x1p-20f + 0x1p-30f, 0x1p-20f, 0x1p-20f}},
    {{0, 0, 0}, {1.25f, 1.75f, 1}},  // equal in whole numbers only
    {{5, -3, 2}, {5, -3, 2}},        // a point
};

// Every third cell has two longest sides or three, or a side of length 0.
static BBox3D roll_split(Random *random, int i)
{
    const int edge = edge_of(i, N_SPLITS, COUNT(nearly_cubes));
    if (edge >= 0) {
        return nearly_cubes[edge];
    }
    BBox3D cell = roll_cell(random);
    const int kind = i % 15;
    const float length = random_eighth(random, 40, 60);
    for (int axis = 0; axis < 3; axis++) {
        if (kind == 0 || (kind <= 3 && axis != kind - 1)) {
            cell.max[axis] = cell.min[axis] + length;
        } else if (kind == 4 && axis == i / 15 % 3) {
            cell.max[axis] = cell.min[axis];
        }
    }
    return cell;
}

// Spheres that reach into thin cells between their corners, and one that does not: large ones,
// whose own outermost points are outside, too. Then spheres of radius 0, which are points: within
// the cell, on a side, an edge and a corner of it, and beside it.
static const SphereBoxJob odd_inside[] = {
    {{32, 20, 32, 24}, {{0, 0, 0}, {64, 1, 64}}}, {{20, 32, 32, -24}, {{0, 0, 0}, {1, 64, 64}}},
    {{10, 10, 32, 15}, {{0, 0, 0}, {1, 1, 64}}},  {{32, 24.5f, 32, 23}, {{0, 0, 0}, {64, 1, 64}}},
    {{4, 4, 4, 0}, {{0, 0, 0}, {8, 8, 8}}},       {{8, 4, 4, 0}, {{0, 0, 0}, {8, 8, 8}}},
    {{8, 0, 4, 0}, {{0, 0, 0}, {8, 8, 8}}},       {{8, 8, 8, 0}, {{0, 0, 0}, {8, 8, 8}}},
    {{8.125f, 4, 4, 0}, {{0, 0, 0}, {8, 8, 8}}},  {{8, 8, -0.125f, 0}, {{0, 0, 0}, {8, 8, 8}}},
};

// Do sphere and cell share a point of their boundaries, and no more?
static int touches(SphereBoxJob in)
{
    const float centre[3] = {in.sphere.x, in.sphere.y, in.sphere.z};
    double distance2 = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double outside = outside_of(centre[axis], in.box.min[axis], in.box.max[axis]);
        distance2 += outside * outside;
    }
    return distance2 == (double)in.sphere.radius * in.sphere.radius;
}

// Spheres of any place beside, in and around the cell, its size or smaller, none of which only
// touches it; some with a negative radius.
static SphereBoxJob roll_inside(Random *random, int i)
{
    const int edge = edge_of(i, N_INSIDE, COUNT(odd_inside));
    if (edge >= 0) {
        return odd_inside[edge];
    }
    const BBox3D box = roll_cell(random);
    // In every fourth the centre is in the cell, or level with it on two axes.
    const int n_level = i % 4 == 0 ? (int)random_integer(random, 2, 3) : 0;
    const int first = (int)random_integer(random, 0, 2);
    float centre[3];
    for (int j = 0; j < 3; j++) {
        const int axis = (first + j) % 3;
        centre[axis] =
            j < n_level ? (box.min[axis] + box.max[axis]) / 2 : random_eighth(random, -60, 90);
    }
    // Not among the first: a mistake that has nothing to do with them is shown without them.
    const int sign = i > N_INSIDE / 2 && i % 5 == 0 ? -1 : 1;
    SphereBoxJob job = {sphere_at(centre, random_eighth(random, 1, 70)), box};
    job.sphere.radius += touches(job) ? 0.125f : 0;
    job.sphere.radius *= (float)sign;
    return job;
}

// So small that every epsilon is larger.
#define TINY_STEP 0x1p-30f

// Beside a side: large spheres whose squared radius float would round down and up, and one that
// misses by a step of float; a tiny one, and two that miss by a fifth; one whose distance float
// would round to its radius.
static const SphereBoxJob beside[] = {
    {{64 + 4097, 32, 32, 4097}, {{0, 0, 0}, {64, 64, 64}}},
    {{32, 32, -4099, 4099}, {{0, 0, 0}, {64, 64, 64}}},
    {{32, 64 + 4097 + 0x1p-11f, 32, 4097}, {{0, 0, 0}, {64, 64, 64}}},
    {{-0.5f, 5 * TINY_STEP, -0.5f, 5 * TINY_STEP}, {{-1, -1, -1}, {0, 0, 0}}},
    {{-0.5f, -0.5f, 6 * TINY_STEP, 5 * TINY_STEP}, {{-1, -1, -1}, {0, 0, 0}}},
    {{6 * TINY_STEP, -0.5f, -0.5f, -5 * TINY_STEP}, {{-1, -1, -1}, {0, 0, 0}}},
    {{1, 32, 32, 1}, {{-64, 0, 0}, {-0x1p-26f, 64, 64}}},
};

// A sphere that touches a side, an edge or a corner of the cell from outside, or misses it by an
// eighth.
static SphereBoxJob roll_touching(Random *random, int i)
{
    const int edge = edge_of(i, N_TOUCHING, COUNT(beside));
    if (edge >= 0) {
        return beside[edge];
    }
    // Whole numbers with a² + b² + c² = d².
    static const int quadruples[][3][4] = {
        {{3, 0, 0, 3}, {8, 0, 0, 8}, {17, 0, 0, 17}},
        {{3, 4, 0, 5}, {5, 12, 0, 13}, {8, 15, 0, 17}},
        {{2, 3, 6, 7}, {1, 4, 8, 9}, {3, 4, 12, 13}},
    };
    const BBox3D box = roll_cell(random);
    const int kind = (int)random_integer(random, 0, 2);
    const int *distances = quadruples[kind][random_integer(random, 0, 2)];
    const int first = (int)random_integer(random, 0, 2);
    const float miss = random_integer(random, 0, 3) == 0 ? 0.125f : 0;
    float centre[3];
    for (int i = 0; i < 3; i++) {
        const int axis = (first + i) % 3;
        const float distance = (float)distances[i] + miss;
        if (distances[i] == 0) {
            centre[axis] = (box.min[axis] + box.max[axis]) / 2;
        } else if (random_integer(random, 0, 1)) {
            centre[axis] = box.max[axis] + distance;
        } else {
            centre[axis] = box.min[axis] - distance;
        }
    }
    return (SphereBoxJob){sphere_at(centre, (float)distances[3]), box};
}

// Beyond edges and corners: whole numbers with a² + b² + c² = d² + 1, too large for float,
// which takes both for equal; and such numbers, and four with a² + b² + c² = d², tiny. Then one
// where a² + b² is more than 1, and double holds that, but not its root.
static const SphereBoxJob beyond[] = {
    {{64 + 738, 64 + 4031, 32, 4098}, {{0, 0, 0}, {64, 64, 64}}},
    {{64 + 1759, -2456, 64 + 2772, 4100}, {{0, 0, 0}, {64, 64, 64}}},
    {{-1870, -2157, -2954, 4108}, {{0, 0, 0}, {64, 64, 64}}},
    {{-0.5f, 4 * TINY_STEP, 7 * TINY_STEP, 8 * TINY_STEP}, {{-1, -1, -1}, {0, 0, 0}}},
    {{TINY_STEP, 4 * TINY_STEP, 7 * TINY_STEP, 8 * TINY_STEP}, {{-1, -1, -1}, {0, 0, 0}}},
    {{2 * TINY_STEP, 3 * TINY_STEP, 6 * TINY_STEP, 7 * TINY_STEP}, {{-1, -1, -1}, {0, 0, 0}}},
    {{6, 0x1p-26f, 2, 1}, {{0, -5, 0}, {5, 0, 5}}},
};

// A sphere beyond a corner or an edge, nearer than its radius on each axis: its bounding cube
// overlaps the cell, the sphere itself may not.
static SphereBoxJob roll_corner(Random *random, int i)
{
    const int edge = edge_of(i, N_CORNER, COUNT(beyond));
    if (edge >= 0) {
        return beyond[edge];
    }
    const BBox3D box = roll_cell(random);
    const int first = (int)random_integer(random, 0, 2);
    const float radius = (float)random_integer(random, 4, 40);
    float centre[3];
    for (int i = 0; i < 3; i++) {
        const int axis = (first + i) % 3;
        const int lowest = i == 0 ? 8 : i == 1 ? 3 : 0;
        const float distance = radius * (float)random_integer(random, lowest, 15) / 16;
        centre[axis] =
            random_integer(random, 0, 1) ? box.max[axis] + distance : box.min[axis] - distance;
    }
    return (SphereBoxJob){sphere_at(centre, radius), box};
}

// No level may be refused or allowed by chance: all that a tree could have, and of the larger ones
// those that look like small ones to who keeps 8 or 16 bits. Twice the largest is an int, too.
static i32 roll_level(Random *random, int i)
{
    static const i32 around[N_AROUND] = {-1, 0, 1, TODO_SIZE, TODO_SIZE + 1};
    const int j = i - N_LEVELS_IN_ORDER, power = 10 + j / N_AROUND;
    return j < 0                     ? i + 1
           : j < N_POWERS * N_AROUND ? (i32)(1u << power) + around[j % N_AROUND]
                                     : (i32)random_integer(random, TODO_SIZE + 1, 1 << 24);
}

static void roll_inputs(Random *random, Job06 *job)
{
    for (int i = 0; i < N_SPLITS; i++) {
        job->splits[i] = roll_split(random, i);
    }
    for (int i = 0; i < N_OVERLAPS; i++) {
        const int j = i - N_INSIDE;
        job->overlaps[i] = j < 0            ? roll_inside(random, i)
                           : j < N_TOUCHING ? roll_touching(random, j)
                                            : roll_corner(random, j - N_TOUCHING);
    }
    for (int i = 0; i < N_PACKS; i++) {
        job->packs[i] = pack_roll(random, edge_of(i, N_PACKS, N_PACK_EDGES), 0);
    }
    for (int i = 0; i < N_LEVELS; i++) {
        job->levels[i] = roll_level(random, i);
    }
}

// ---- Scenes -------------------------------------------------------------------------------------

// The size of the report's drawings.
enum { WIDTH = 320, HEIGHT = 240 };

static int roll_named(TreeScene3D *scene, Random *random, const char *name, KdTreeLimits limits)
{
    *scene = (TreeScene3D){.limits = limits};
    snprintf(scene->title, sizeof scene->title, "a scene like \"%s\"", name);
    if (scene3d_generate(name, WIDTH, HEIGHT, &scene->scene) != 0) {
        return -1;
    }
    scene3d_vary(&scene->scene, random);
    return 0;
}

// Random spheres as they come: 24 bits of every coordinate are in use, so much is rounded.
static int roll_random(TreeScene3D *scene, Random *random, int n_spheres, KdTreeLimits limits)
{
    *scene = (TreeScene3D){.limits = limits};
    snprintf(scene->title, sizeof scene->title, "random scene, %d spheres", n_spheres);
    float min_radius, max_radius;
    scene3d_default_radii(n_spheres, &min_radius, &max_radius);
    if (scene3d_random(n_spheres, random_bits(random), min_radius, max_radius, &scene->scene) !=
        0) {
        return -1;
    }
    scene->scene.width = WIDTH;
    scene->scene.height = HEIGHT;
    return 0;
}

// The same on a grid of 1/8 in a box of other sides: nothing is rounded. Every fifth radius is
// negative.
static int roll_on_grid(TreeScene3D *scene, Random *random, int n_spheres, const int corner[3],
                        KdTreeLimits limits)
{
    const int opposite[3] = {-corner[0], -corner[1], -corner[2]};
    if (roll_random(scene, random, n_spheres, limits) != 0) {
        return -1;
    }
    snprintf(scene->title, sizeof scene->title, "random scene on a grid, %d spheres", n_spheres);
    for (int i = 0; i < n_spheres; i++) {
        scene->scene.spheres[i] = roll_sphere(random, opposite, corner, 2);
        scene->scene.spheres[i].radius *= i % 5 == 0 ? -1 : 1;
    }
    return 0;
}

// The radius of tiny spheres is 2^-TINY. After TINY halvings of each axis the cells are as small;
// below, both children would hold the spheres, and twice as many nodes on every level.
enum { TINY = 18 };
_Static_assert(TODO_SIZE + 2 < 3 * TINY, "nodes would double level by level");

// Two tiny spheres at one place and a far one. No plane ever comes between the two, so the tree
// gets as deep as the limit says; but only ever one of two children is not empty: it stays small.
static int roll_deep(TreeScene3D *scene, Random *random, int maxDepth)
{
    if (roll_random(scene, random, 3, (KdTreeLimits){maxDepth, 1}) != 0) {
        return -1;
    }
    snprintf(scene->title, sizeof scene->title, "two tiny spheres at one place and a far one");
    float place[3];
    for (int axis = 0; axis < 3; axis++) {
        place[axis] = (float)random_integer(random, 1, 1 << 20) / (1 << 21);
    }
    scene->scene.spheres[0] = scene->scene.spheres[1] = sphere_at(place, 1.0f / (1 << TINY));
    scene->scene.spheres[2] = (Sphere){-1, -1, -1, 0.25f};
    return 0;
}

static int roll_scenes(Random *random, Job06 *job)
{
    static const int wide[3] = {16, 12, 8}, tall[3] = {4, 4, 12};
    TreeScene3D *scenes = job->scenes;
    int result = roll_on_grid(&scenes[0], random, 150, wide, (KdTreeLimits){9, 4});
    result |= roll_on_grid(&scenes[1], random, 60, tall, (KdTreeLimits){7, 2});
    result |= roll_random(&scenes[2], random, 250, (KdTreeLimits){12, 4});
    result |= roll_named(&scenes[3], random, "planes", (KdTreeLimits){10, 3});
    result |= roll_named(&scenes[4], random, "inside", (KdTreeLimits){7, 3});
    result |= roll_named(&scenes[5], random, "coincident", (KdTreeLimits){6, 8});
    result |= roll_named(&scenes[6], random, "large-small", (KdTreeLimits){10, 6});
    result |= roll_named(&scenes[7], random, "one", (KdTreeLimits){4, 1});
    result |= roll_named(&scenes[8], random, "none", (KdTreeLimits){4, 1});
    result |= roll_random(&scenes[9], random, 300, (KdTreeLimits){1, 3});
    result |= roll_deep(&scenes[JUST_FITS], random, TODO_SIZE + 1);
    result |= roll_deep(&scenes[TOO_DEEP], random, TODO_SIZE + 2);
    for (int k = 0; result == 0 && k <= JUST_FITS; k++) {
        result = tree3d_expect(&scenes[k], (u32)k, &job->job.growth);
    }
    TreeScene3D deep = scenes[TOO_DEEP];
    if (result == 0) {
        result = tree3d_expect(&deep, TOO_DEEP, &job->too_deep);
        tree3d_free(&deep.tree);
    }
    return result;
}

// ---- The job ------------------------------------------------------------------------------------

int roll_job_06(void *pointer, Random *random)
{
    Job06 *job = pointer;
    const int result = roll_scenes(random, job);
    if (result == 0) {
        roll_inputs(random, job);
    }
    return result;
}

void job_06_release(void *pointer)
{
    Job06 *job = pointer;
    growth_free(&job->too_deep);
}
