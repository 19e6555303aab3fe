// Drawing lab 03's job from the seed: see judge_03.h.
#include "judge_03.h"

#include "complain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    KdTreeLimits limits;
} edges[N_EDGES] = {{"none", {4, 1}}, {"tiny", {8, 1}},     {"outside", {6, 2}},
                    {"huge", {4, 1}}, {"touching", {1, 1}}, {"borders", {7, 2}}};

// A random scene whose bounds are [0, 256] in x and y, so that halves are whole pixels.
static int draw_borders(Random *random, JobScene *scene)
{
    if (job_scene_random(scene, random, 200, 9, 200, 200) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "random scene in a 256x256 root");
    for (int i = 0; i < scene->scene.n_circles; i++) {
        // Centres of 0 to 200 move to where circles of 9 pixels stay inside.
        scene->scene.circles[i].x += 20;
        scene->scene.circles[i].y += 20;
    }
    Circle *corner = scene->scene.circles;
    corner[0].x = corner[0].y = 1;
    corner[0].radius = 1;
    corner[1].x = corner[1].y = 254;
    corner[1].radius = 1.5f;
    scene->scene.width = scene->scene.height = 256;
    return job_scene_grow_tree(scene, (KdTreeLimits){12, 4});
}

int cell_holds(BBox2D box, double x, double y)
{
    return x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY;
}

// A whole coordinate in [lowest, highest).
static i32 coordinate(Random *random, float lowest, float highest)
{
    return (i32)random_integer(random, (int64_t)lowest, (int64_t)highest - 1);
}

// A pixel of a random inner node; on the border between its children when asked for.
static ChildJob draw_child(Random *random, const KdTree2D *tree, int on_border)
{
    for (;;) {
        const u32 id = (u32)random_integer(random, 0, tree->n_nodes - 1);
        const BBox2D box = tree->nodes_BBox[id];
        if (tree->nodes_flag[id] == LEAF || box.maxX - box.minX < 4 || box.maxY - box.minY < 4) {
            continue;
        }
        const i32 x = coordinate(random, box.minX, box.maxX);
        const i32 y = coordinate(random, box.minY, box.maxY);
        ChildJob job = {x, y, id};
        const BBox2D left = tree->nodes_BBox[tree->nodes_Relations[id].lChild];
        if (on_border) {
            // One coordinate on a border: the lower one of the node, or the one the children share.
            const int lower = random_integer(random, 0, 3) == 0;
            if (left.maxX < box.maxX) {
                job.x = (i32)(lower ? box.minX : left.maxX);
            } else {
                job.y = (i32)(lower ? box.minY : left.maxY);
            }
        } else if ((float)job.x == left.maxX || (float)job.y == left.maxY) {
            continue;
        }
        return job;
    }
}

// Give each leaf one more circle, nearest of all, that covers everything in the leaf's own colour:
// the picture then shows which leaf each pixel asked.
static int colour_leaves(JobScene *scene)
{
    Scene2D *s = &scene->scene;
    KdTree2D *tree = &scene->tree;
    const u32 n_circles = (u32)s->n_circles;
    u32 *map = malloc((tree->n_map + tree->n_nodes) * sizeof *map);
    Circle *circles = realloc(s->circles, (n_circles + tree->n_nodes) * sizeof *circles);
    s->circles = circles ? circles : s->circles;
    if (map == NULL || circles == NULL) {
        complain("grade: no memory for a scene");
        free(map);
        return -1;
    }
    u32 n_map = 0, n = n_circles;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] != LEAF) {
            continue;
        }
        const u32 *list = tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
        tree->nodes_Relations[id].circleMapOffset = n_map;
        map[n_map++] = list[0] + 1;
        memcpy(map + n_map, list + 1, list[0] * sizeof *map);
        n_map += list[0];
        map[n_map++] = n;
        circles[n++] = (Circle){.radius = 100000,
                                .depth = -1,
                                .r = (float)(id % 7) / 6,
                                .g = (float)(id / 7 % 7) / 6,
                                .b = (float)(id / 49) / 64,
                                .a = 1};
    }
    free(tree->mapNode2Circles);
    tree->mapNode2Circles = map;
    tree->n_map = n_map;
    s->n_circles = (int)n;
    return 0;
}

u32 leaf_at(const KdTree2D *tree, int x, int y)
{
    u32 id = 0;
    while (id < tree->n_nodes &&
           (tree->nodes_flag[id] != LEAF || !cell_holds(tree->nodes_BBox[id], x, y))) {
        id++;
    }
    return id;
}

// The picture of the leaf map: outside the root a pixel may end in any leaf.
static int expect_leaf_map(JobScene *scene)
{
    if (job_scene_expect(scene) != 0) {
        return -1;
    }
    const KdTree2D *tree = &scene->tree;
    ExpectedPicture *expected = &scene->picture.expected;
    Image *reference = &expected->reference;
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            const size_t pixel = (size_t)y * (size_t)reference->width + (size_t)x;
            const u32 leaf = leaf_at(tree, x, y);
            expected->tolerances[pixel] = leaf == tree->n_nodes ? INFINITY : 0;
            if (leaf < tree->n_nodes) {
                const u32 *list =
                    tree->mapNode2Circles + tree->nodes_Relations[leaf].circleMapOffset;
                const Circle own = scene->scene.circles[list[list[0]]];
                const float color[IMAGE_CHANNELS] = {own.r, own.g, own.b, own.a};
                memcpy(reference->pixels + pixel * IMAGE_CHANNELS, color, sizeof color);
            }
        }
    }
    expected->draw_mistaken = NULL;
    return 0;
}

static int draw_leaf_map(Random *random, JobScene *scene)
{
    int result = job_scene_random(scene, random, 60, 12, 128, 96);
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "leaf map (each leaf of the tree has a colour of its own), 128x96");
    if (result == 0) {
        result = job_scene_grow_tree(scene, (KdTreeLimits){8, 3});
    }
    if (result == 0) {
        result = colour_leaves(scene);
    }
    return result == 0 ? expect_leaf_map(scene) : -1;
}

static int draw_scenes(Random *random, JobScene scenes[N_SCENES])
{
    int result = draw_borders(random, &scenes[BORDERS]);
    result |= job_scene_random(&scenes[WIDE], random, 200, 20, 317, 211);
    result |= draw_leaf_map(random, &scenes[LEAF_MAP]);
    result |= job_scene_random(&scenes[RANDOM], random, 150, 12, 96, 128);
    result |= job_scene_random(&scenes[RANDOM + 1], random, 9, 30, 100, 60);
    job_scene_spread_depths(&scenes[RANDOM + 1]);
    result |= job_scene_named(&scenes[ORDER], "equal-depths", 96, 64);
    for (int i = 0; i < N_EDGES; i++) {
        result |= job_scene_named(&scenes[EDGES + i], edges[i].name, 64, 48);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        if (scenes[k].tree.n_nodes == 0) {
            const KdTreeLimits limits = {9, 6};
            result = job_scene_grow_tree(&scenes[k], k < EDGES ? limits : edges[k - EDGES].limits);
        }
        if (result == 0 && k != LEAF_MAP) {
            result = job_scene_expect(&scenes[k]);
        }
    }
    return result;
}

int job_03_draw(void *pointer, Random *random)
{
    Job03 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_list_picture(&job->job, &job->scenes[k].picture);
    }
    const int result = draw_scenes(random, job->scenes);
    for (int i = 0; result == 0 && i < N_CHILDREN; i++) {
        job->children[i] = draw_child(random, &job->scenes[BORDERS].tree, i >= N_INSIDE);
    }
    return result;
}

void job_03_release(void *pointer)
{
    Job03 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene_free(&job->scenes[k]);
    }
}

int job_03_write_scene(const void *pointer, int k, FILE *file)
{
    return job_scene_write(&((const Job03 *)pointer)->scenes[k], k, file);
}
