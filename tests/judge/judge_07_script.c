// The scripted world of judge_07_script.h: its trees, and a right search through it.
#include "judge_07_script.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const OracleRules3D right = {0};

// ---- The stand-ins ------------------------------------------------------------------------------

// What they know on the device under the same names.
typedef unsigned int uint;
typedef struct Ray {
    Vec3 origin, direction;
} Ray;
typedef struct Hit {
    float t;
    uint sphere;
} Hit;
enum { ONLY_NEAR, ONLY_FAR, BOTH };

static int stand_in_clip(BBox3D box, Ray ray, float *t_min, float *t_max)
{
#include "07-kdtree-3d-trace/clip_to_box.cl"
}

static uint stand_in_side(KdNode3 node, float origin, float inverse)
{
#include "07-kdtree-3d-trace/near_side.cl"
}

static int stand_in_children(KdNode3 node, float origin, float inverse, float t_min, float t_max,
                             float *t_split)
{
#include "07-kdtree-3d-trace/children_on_ray.cl"
}

static void stand_in_leaf(KdNode3 node, const uint *sphere_ids, const Sphere *spheres, Ray ray,
                          Hit *hit)
{
#include "07-kdtree-3d-trace/search_leaf.cl"
}

// ---- A right search -----------------------------------------------------------------------------

typedef struct Search {
    const JobScene3D *scene;
    Ray ray;
    float origins[3], inverses[3];
    Hit hit;
    Work work;
    u32 n_empty;
} Search;

// Visit a node's part of the ray. Returns 1 when the search is over.
static int visit(Search *search, u32 id, float t_min, float t_max, u32 n_waiting)
{
    const KdTree3D *tree = &search->scene->tree;
    const KdNode3 node = tree->nodes[id];
    Work *work = &search->work;
    if (node.split_axis == KD_LEAF) {
        work->n_leaves_visited++;
        work->n_tests += node.n_spheres;  // the stand-in counts them
        search->n_empty += node.n_spheres == 0;
        stand_in_leaf(node, tree->sphere_ids, search->scene->scene.spheres, search->ray,
                      &search->hit);
        return search->hit.t < t_max;
    }
    const float origin = search->origins[node.split_axis];
    const float inverse = search->inverses[node.split_axis];
    const u32 near = node.first + stand_in_side(node, origin, inverse);
    const u32 far = 2 * node.first + 1 - near;
    float t_split;
    work->n_nodes_visited++;
    switch (stand_in_children(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return visit(search, near, t_min, t_max, n_waiting);
    case ONLY_FAR:
        return visit(search, far, t_min, t_max, n_waiting);
    default:
        work->stack_depth = n_waiting >= work->stack_depth ? n_waiting + 1 : work->stack_depth;
        return visit(search, near, t_min, t_split, n_waiting + 1) ||
               visit(search, far, t_split, t_max, n_waiting);
    }
}

static OracleRay ray_of(const JobScene3D *scene, int x, int y)
{
    const Scene3D *s = &scene->scene;
    return oracle3d_primary_ray(&scene->camera, x, y, s->width, s->height, &right);
}

ScriptedSearch scripted_07_search(const JobScene3D *scene, int x, int y)
{
    const OracleVector d = ray_of(scene, x, y).direction;
    const Vec3 eye = scene->camera.eye, way = {(float)d.x, (float)d.y, (float)d.z};
    Search search = {.scene = scene,
                     .ray = {eye, way},
                     .origins = {eye.x, eye.y, eye.z},
                     .inverses = {1 / way.x, 1 / way.y, 1 / way.z},
                     .hit = {INFINITY, ORACLE_NO_SPHERE}};
    float t_min = 0, t_max = INFINITY;
    if (stand_in_clip(scene->tree.bounds, search.ray, &t_min, &t_max)) {
        visit(&search, 0, t_min, t_max, 0);
    }
    return (ScriptedSearch){search.hit.t, search.hit.sphere, search.work, search.n_empty};
}

// ---- Trees --------------------------------------------------------------------------------------

enum { N_SPHERES = 63, MAX_LEVELS = TODO_SIZE + 1, MAX_NODES = 2048, MAX_LEAF = 4 };

// One child of every inner node is a leaf, and the other, the near or the far one, goes on.
typedef enum Spine { NO_SPINE, NEAR_SPINE, FAR_SPINE } Spine;

typedef struct TreePlan {
    const char *title;
    int levels;
    int percent_inner;  // of the nodes between the first two levels and the last
    int percent_empty;  // of the leaves
    int percent_on;     // of the planes, with the eye on them
    Spine spine;
} TreePlan;

static const TreePlan plans[N_SCRIPTED] = {
    {"two levels", 2, 100, 0, 10, NO_SPINE},
    {"three levels", 3, 100, 20, 10, NO_SPINE},
    {"five levels", 5, 80, 20, 20, NO_SPINE},
    {"seven levels", 7, 80, 20, 10, NO_SPINE},
    {"nine levels", 9, 90, 10, 20, NO_SPINE},
    {"ten levels", 10, 90, 60, 20, NO_SPINE},
    // The edge cases.
    {"one leaf", 1, 0, 0, 0, NO_SPINE},
    {"one empty leaf", 1, 0, 100, 0, NO_SPINE},
    {"no spheres", 6, 80, 100, 10, NO_SPINE},
    {"eye on all planes", 7, 90, 10, 100, NO_SPINE},
    {"as deep as may be", MAX_LEVELS, 0, 0, 0, NEAR_SPINE},
    {"as deep, mostly empty", MAX_LEVELS, 0, 90, 0, NEAR_SPINE},
    {"as deep on the far side", MAX_LEVELS, 0, 50, 0, FAR_SPINE},
};

static int draws(Random *random, int percent)
{
    return random_integer(random, 0, 99) < percent;
}

// The table for near_side of a plane at `pos`.
static u32 side_table(float pos)
{
    u32 table = 0;
    for (u32 eye = 0; eye < 8; eye++) {
        const u32 is_above = (float)eye > pos, is_on = (float)eye == pos;
        table |= is_above << eye | (is_above | is_on) << (eye + 8);
    }
    return table;
}

static KdNode3 draw_inner(Random *random, const TreePlan *plan, const float eye[3], u32 first)
{
    const u32 axis = (u32)random_integer(random, 0, 2);
    const float beside = (float)random_integer(random, -3, 2) + 0.5f;
    const float pos = draws(random, plan->percent_on) ? eye[axis] : eye[axis] + beside;
    const u32 meets_both = plan->spine == NEAR_SPINE ? 1u << 16 : 0;
    return (KdNode3){pos, axis, first, side_table(pos) | meets_both};
}

static KdNode3 draw_leaf(Random *random, const TreePlan *plan, KdTree3D *tree)
{
    const u32 n = draws(random, plan->percent_empty) ? 0 : (u32)random_integer(random, 1, MAX_LEAF);
    const KdNode3 leaf = {0, KD_LEAF, tree->n_sphere_ids, n};
    for (u32 i = 0; i < n; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = (u32)random_integer(random, 0, N_SPHERES - 1);
    }
    return leaf;
}

// Is this child of an inner node the one that goes on?
static int is_spine(const TreePlan *plan, KdNode3 parent, const float eye[3], u32 child)
{
    const u32 near = parent.first + (eye[parent.split_axis] > parent.split_pos);
    return (child == near) == (plan->spine == NEAR_SPINE);
}

// Breadth-first, as trees are packed. Returns 0, or -1 after one message.
static int grow(Random *random, const TreePlan *plan, const float eye[3], KdTree3D *tree)
{
    int levels[MAX_NODES] = {1}, may_split[MAX_NODES] = {1};
    tree->nodes = calloc(MAX_NODES, sizeof *tree->nodes);
    tree->sphere_ids = calloc(MAX_NODES * MAX_LEAF + 1, sizeof *tree->sphere_ids);
    if (tree->nodes == NULL || tree->sphere_ids == NULL) {
        fprintf(stderr, "grade: no memory for a tree\n");
        return -1;
    }
    tree->n_nodes = 1;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const u32 first = tree->n_nodes;
        const int splits = levels[id] < plan->levels && first + 2 <= MAX_NODES && may_split[id] &&
                           (plan->spine || levels[id] <= 2 || draws(random, plan->percent_inner));
        if (!splits) {
            tree->nodes[id] = draw_leaf(random, plan, tree);
            continue;
        }
        tree->nodes[id] = draw_inner(random, plan, eye, first);
        tree->n_nodes += 2;
        for (u32 child = first; child < first + 2; child++) {
            levels[child] = levels[id] + 1;
            may_split[child] =
                plan->spine == NO_SPINE || is_spine(plan, tree->nodes[id], eye, child);
        }
    }
    tree->n_sphere_ids += tree->n_sphere_ids == 0;  // no buffer is empty
    return 0;
}

// ---- Scenes -------------------------------------------------------------------------------------

// Sphere i is hit at its radius, 1 to N_SPHERES in no order. All lie behind the eye and the lights
// farther behind, so that every normal is turned towards both.
static void place(Random *random, Scene3D *s)
{
    for (int i = 0; i < N_SPHERES; i++) {
        s->spheres[i] = (Sphere){random_grid(random, -20, 20), random_grid(random, -20, 20),
                                 random_grid(random, 30, 60), (float)(i * 26 % N_SPHERES + 1)};
    }
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].position.z = 200;
    }
}

static OracleNear color_of(const JobScene3D *scene, int x, int y)
{
    const Scene3D *s = &scene->scene;
    const ScriptedSearch found = scripted_07_search(scene, x, y);
    if (found.sphere == ORACLE_NO_SPHERE) {
        return (OracleNear){{s->background.x, s->background.y, s->background.z}, 0};
    }
    const OracleRay ray = ray_of(scene, x, y);
    const double t = found.t, size = fabs(ray.origin.x) + fabs(ray.origin.y) + fabs(ray.origin.z);
    const OracleNear point = {{ray.origin.x + t * ray.direction.x,
                               ray.origin.y + t * ray.direction.y,
                               ray.origin.z + t * ray.direction.z},
                              ray.direction_error * t + 4 * 0x1p-24 * (size + t)};
    const OracleNear direction = {ray.direction, ray.direction_error};
    const OracleNear normal = oracle3d_normal(s->spheres[found.sphere], point, direction, &right);
    return oracle3d_shade(point, normal, &s->materials[s->material_ids[found.sphere]], s->lights,
                          s->n_lights, &right);
}

static int expect_picture(JobScene3D *scene)
{
    const int width = scene->scene.width, height = scene->scene.height;
    ExpectedPicture *expected = &scene->picture.expected;
    expected->tolerances = calloc((size_t)width * (size_t)height, sizeof *expected->tolerances);
    if (expected->tolerances == NULL || image_create(width, height, &expected->reference) != 0) {
        fprintf(stderr, "grade: no memory for a picture\n");
        return -1;
    }
    for (int i = 0; i < width * height; i++) {
        const OracleNear color = color_of(scene, i % width, i / width);
        const float channels[IMAGE_CHANNELS] = {(float)color.value.x, (float)color.value.y,
                                                (float)color.value.z, 1};
        memcpy(expected->reference.pixels + (size_t)i * IMAGE_CHANNELS, channels, sizeof channels);
        expected->tolerances[i] = (float)color.error;
    }
    return 0;
}

static int draw_scene(Random *random, const TreePlan *plan, JobScene3D *scene)
{
    const int width = 48, height = 32;
    // Seven whole numbers, as the tables of the nodes have them, and of each axis another.
    const float eye[3] = {(float)random_integer(random, 0, 1), (float)random_integer(random, 2, 4),
                          (float)random_integer(random, 5, 7)};
    if (job_scene3d_random(scene, random, N_SPHERES, 0.25f, 0.5f, width, height) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "scripted, %s", plan->title);
    place(random, &scene->scene);
    scene->camera =
        (Camera){{eye[0], eye[1], eye[2]}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, (float)width / 4096};
    scene->tree.bounds = (BBox3D){{1, 1, 1}, {N_SPHERES + 1, 8, 8}};
    return grow(random, plan, eye, &scene->tree) == 0 ? expect_picture(scene) : -1;
}

int scripted_07_draw(Random *random, JobScene3D scenes[N_SCRIPTED])
{
    int result = 0;
    for (int k = 0; result == 0 && k < N_SCRIPTED; k++) {
        result = draw_scene(random, &plans[k], &scenes[k]);
    }
    return result;
}
