// Drawing lab 06's job from the seed: see judge_06.h.
//
// The functions' inputs are on coarse grids, so that no right answer depends on rounding: squared
// distances are whole numbers of grid squares below 2^24, which float holds exactly.
#include "judge_06.h"

#include "job_sections.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

// A number on a grid of 1/8, from lowest to highest.
static float random_eighth(Random *random, int lowest, int highest)
{
    return (float)random_integer(random, 8 * (int64_t)lowest, 8 * (int64_t)highest) / 8;
}

static Sphere sphere_at(const float centre[3], float radius)
{
    return (Sphere){centre[0], centre[1], centre[2], radius};
}

// A sphere with its centre in the box from lowest to highest.
static Sphere draw_sphere(Random *random, const int lowest[3], const int highest[3], int max_radius)
{
    float centre[3];
    for (int axis = 0; axis < 3; axis++) {
        centre[axis] = random_eighth(random, lowest[axis], highest[axis]);
    }
    return sphere_at(centre, random_eighth(random, 1, max_radius));
}

static BBox3D draw_cell(Random *random)
{
    BBox3D cell;
    for (int axis = 0; axis < 3; axis++) {
        cell.min[axis] = random_eighth(random, -50, 40);
        cell.max[axis] = cell.min[axis] + random_eighth(random, 1, 40);
    }
    return cell;
}

// ---- Inputs of the functions --------------------------------------------------------------------

// Every third cell has two longest sides or three, or a side of length 0.
static BBox3D draw_split(Random *random, int i)
{
    BBox3D cell = draw_cell(random);
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

// Spheres of any place beside, in and around the cell, its size or smaller; some with a negative
// radius.
static SphereBoxJob draw_inside(Random *random, int i)
{
    const BBox3D box = draw_cell(random);
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
    return (SphereBoxJob){sphere_at(centre, (float)sign * random_eighth(random, 1, 70)), box};
}

// A sphere that touches a side, an edge or a corner of the cell from outside, or misses it by an
// eighth.
static SphereBoxJob draw_touching(Random *random)
{
    // Whole numbers with a² + b² + c² = d².
    static const int quadruples[][3][4] = {
        {{3, 0, 0, 3}, {8, 0, 0, 8}, {17, 0, 0, 17}},
        {{3, 4, 0, 5}, {5, 12, 0, 13}, {8, 15, 0, 17}},
        {{2, 3, 6, 7}, {1, 4, 8, 9}, {3, 4, 12, 13}},
    };
    const BBox3D box = draw_cell(random);
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

// A sphere beyond a corner or an edge, nearer than its radius on each axis: its bounding cube
// overlaps the cell, the sphere itself may not.
static SphereBoxJob draw_corner(Random *random)
{
    const BBox3D box = draw_cell(random);
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

static PackJob3D draw_pack(Random *random)
{
    PackJob3D job = {.id = (u32)random_integer(random, 1, PACK_NODES - 1)};
    job.n_sphere_ids = (u32)random_integer(random, 1, 20);
    job.n_ids = (u32)random_integer(random, 0, PACK_MAX_IDS);
    u32 id = (u32)random_integer(random, 0, 5);
    for (u32 i = 0; i < job.n_ids; i++) {
        job.ids[i] = id;
        id += (u32)random_integer(random, 1, 90);
    }
    return job;
}

static void draw_inputs(Random *random, Job06 *job)
{
    for (int i = 0; i < N_SPLITS; i++) {
        job->splits[i] = draw_split(random, i);
    }
    for (int i = 0; i < N_OVERLAPS; i++) {
        job->overlaps[i] = i < N_INSIDE                ? draw_inside(random, i)
                           : i < N_INSIDE + N_TOUCHING ? draw_touching(random)
                                                       : draw_corner(random);
    }
    for (int i = 0; i < N_PACKS; i++) {
        job->packs[i] = draw_pack(random);
    }
}

// ---- Scenes -------------------------------------------------------------------------------------

// The size of the report's drawings.
enum { WIDTH = 320, HEIGHT = 240 };

static int draw_named(TreeScene3D *scene, const char *name, KdTreeLimits limits)
{
    *scene = (TreeScene3D){.limits = limits};
    snprintf(scene->title, sizeof scene->title, "scene \"%s\"", name);
    return scene3d_generate(name, WIDTH, HEIGHT, &scene->scene);
}

// Random spheres as they come: 24 bits of every coordinate are in use, so much is rounded.
static int draw_random(TreeScene3D *scene, Random *random, int n_spheres, KdTreeLimits limits)
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
static int draw_on_grid(TreeScene3D *scene, Random *random, int n_spheres, const int corner[3],
                        KdTreeLimits limits)
{
    const int opposite[3] = {-corner[0], -corner[1], -corner[2]};
    if (draw_random(scene, random, n_spheres, limits) != 0) {
        return -1;
    }
    snprintf(scene->title, sizeof scene->title, "random scene on a grid, %d spheres", n_spheres);
    for (int i = 0; i < n_spheres; i++) {
        scene->scene.spheres[i] = draw_sphere(random, opposite, corner, 2);
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
static int draw_deep(TreeScene3D *scene, Random *random, int maxDepth)
{
    if (draw_random(scene, random, 3, (KdTreeLimits){maxDepth, 1}) != 0) {
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

static int draw_scenes(Random *random, TreeScene3D scenes[N_SCENES])
{
    static const int wide[3] = {16, 12, 8}, tall[3] = {4, 4, 12};
    int result = draw_on_grid(&scenes[0], random, 150, wide, (KdTreeLimits){9, 4});
    result |= draw_on_grid(&scenes[1], random, 60, tall, (KdTreeLimits){7, 2});
    result |= draw_random(&scenes[2], random, 250, (KdTreeLimits){12, 4});
    result |= draw_named(&scenes[3], "planes", (KdTreeLimits){10, 3});
    result |= draw_named(&scenes[4], "inside", (KdTreeLimits){7, 3});
    result |= draw_named(&scenes[5], "coincident", (KdTreeLimits){6, 8});
    result |= draw_named(&scenes[6], "large-small", (KdTreeLimits){10, 6});
    result |= draw_named(&scenes[7], "one", (KdTreeLimits){4, 1});
    result |= draw_named(&scenes[8], "none", (KdTreeLimits){4, 1});
    result |= draw_random(&scenes[9], random, 20, (KdTreeLimits){1, 3});
    result |= draw_deep(&scenes[JUST_FITS], random, TODO_SIZE + 1);
    result |= draw_deep(&scenes[TOO_DEEP], random, TODO_SIZE + 2);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        if (k != TOO_DEEP) {
            result = tree3d_expect(&scenes[k]);
        }
    }
    return result;
}

// ---- Replays ------------------------------------------------------------------------------------

// The children of an inner node of the tree, and their cells.
static void place_children(const KdTree3D *tree, ReplayNode *nodes, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    if (node.split_axis == KD_LEAF) {
        return;
    }
    nodes[id].first_child = node.first;
    nodes[node.first].cell = nodes[node.first + 1].cell = nodes[id].cell;
    nodes[node.first].cell.max[node.split_axis] = node.split_pos;
    nodes[node.first + 1].cell.min[node.split_axis] = node.split_pos;
}

// Append what the builder does on its way to a scene's tree. Returns 0, or -1 after one message.
static int replay_scene(Replay *replay, const TreeScene3D *scene, int k)
{
    const KdTree3D *tree = &scene->tree;
    ReplayNode *nodes = replay_add_scene(replay, (u32)k, tree->n_nodes);
    if (nodes == NULL) {
        return -1;
    }
    int result = 0;
    nodes[0].cell = tree->bounds;
    for (u32 id = 0; result == 0 && id < tree->n_nodes; id++) {
        place_children(tree, nodes, id);
        for (int i = 0; result == 0 && i < scene->scene.n_spheres; i++) {
            if (tree3d_judge_sphere(scene->scene.spheres[i], nodes[id].cell) != SPHERE_OUTSIDE) {
                result = replay_add_id(replay, &nodes[id], (u32)i);
            }
        }
    }
    if (result == 0) {
        replay_go_down(nodes, tree->n_nodes, tree3d_split_fails);
    }
    return result;
}

static int replay_scenes(Job06 *job)
{
    int result = 0;
    for (int k = 0; result == 0 && k <= JUST_FITS; k++) {
        result = replay_scene(&job->replay, &job->scenes[k], k);
    }
    TreeScene3D deep = job->scenes[TOO_DEEP];
    if (result == 0) {
        result = tree3d_expect(&deep);
    }
    if (result == 0) {
        result = replay_scene(&job->too_deep, &deep, TOO_DEEP);
        tree3d_free(&deep.tree);
    }
    return result;
}

// ---- The job ------------------------------------------------------------------------------------

// Write "scene.K.spheres", and behind the spheres one that must not be asked. Returns 0, or -1.
static int write_spheres(const TreeScene3D *scene, int k, FILE *file)
{
    const size_t n = (size_t)scene->scene.n_spheres;
    Sphere *spheres = calloc(n + 1, sizeof *spheres);
    if (spheres == NULL) {
        fprintf(stderr, "grade: no memory for a scene\n");
        return -1;
    }
    if (n > 0) {
        memcpy(spheres, scene->scene.spheres, n * sizeof *spheres);
    }
    spheres[n] = (Sphere){.radius = BEYOND_RADIUS};
    const int result = job_section_write(file, k, "spheres", spheres, (n + 1) * sizeof *spheres);
    free(spheres);
    return result;
}

int job_06_write_levels(FILE *file)
{
    const u32 highest = TODO_LEVELS;
    return section_write(file, "todo", &highest, sizeof highest);
}

// A scene without the expected tree.
static int write_scene(const TreeScene3D *scene, int k, FILE *file)
{
    const TreeJob3D job = {(u32)scene->scene.n_spheres, scene->limits.maxDepth,
                           scene->limits.targetElementsPerNode};
    return job_section_write(file, k, NULL, &job, sizeof job) |
           job_title_write(file, k, scene->title) | write_spheres(scene, k, file);
}

void job_06_free(void *pointer)
{
    Job06 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        tree3d_free(&job->scenes[k].tree);
        scene3d_free(&job->scenes[k].scene);
    }
    replay_free(&job->replay);
    replay_free(&job->too_deep);
    free(job);
}

void *job_06_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job06 *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    int result = draw_scenes(&random, job->scenes);
    if (result == 0) {
        draw_inputs(&random, job);
        result |= replay_scenes(job);
        result |= section_write(file, "splits", job->splits, sizeof job->splits);
        result |= section_write(file, "overlaps", job->overlaps, sizeof job->overlaps);
        result |= section_write(file, "pack", job->packs, sizeof job->packs);
        result |= job_06_write_levels(file);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = write_scene(&job->scenes[k], k, file);
    }
    if (result != 0) {
        job_06_free(job);
        return NULL;
    }
    return job;
}
