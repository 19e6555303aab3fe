// Rolling lab 03's job from the seed: see judge_03.h.
#include "judge_03.h"

#include "complain.h"
#include "job_scene_tree.h"
#include "scene_vary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    KdTreeLimits limits;
} edges[DEPTHS - EDGES] = {{"none", {4, 1}}, {"tiny", {8, 1}},     {"outside", {6, 2}},
                           {"huge", {4, 1}}, {"touching", {1, 1}}, {"borders", {7, 2}}};

static void shift_circles(Scene2D *scene, float shift)
{
    for (int i = 0; i < scene->n_circles; i++) {
        scene->circles[i].x += shift;
        scene->circles[i].y += shift;
    }
}

// A random scene whose bounds are [0, 256] in x and y, so that halves are whole pixels.
static int roll_borders(Random *random, JobScene *scene)
{
    if (job_scene_random(scene, random, 200, 9, 200, 200) != 0) {
        return -1;
    }
    snprintf(scene->picture.title, sizeof scene->picture.title, "random scene in a 256x256 root");
    // Centres of 0 to 200 move to where circles of 9 pixels stay inside.
    shift_circles(&scene->scene, 20);
    Circle *corner = scene->scene.circles;
    corner[0].x = corner[0].y = 1;
    corner[0].radius = 1;
    corner[1].x = corner[1].y = 254;
    corner[1].radius = 1.5f;
    scene->scene.width = scene->scene.height = BORDERS_SIDE;
    return job_scene_grow_tree(scene, (KdTreeLimits){12, 4});
}

// A random scene in the middle of a larger picture.
static int roll_within(Random *random, JobScene *scene)
{
    const int result = job_scene_random(scene, random, 40, 8, 60, 40);
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "random scene, smaller than its picture of 100x80");
    shift_circles(&scene->scene, 20);
    scene->scene.width = 100;
    scene->scene.height = 80;
    return result;
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
static ChildJob roll_child(Random *random, const KdTree2D *tree, int on_border)
{
    for (;;) {
        const u32 id = (u32)random_integer(random, 0, tree->n_nodes - 1);
        const BBox2D box = tree->nodes_BBox[id];
        if (tree->nodes_flag[id] == LEAF || box.maxX - box.minX < 4 || box.maxY - box.minY < 4) {
            continue;
        }
        const i32 x = coordinate(random, box.minX, box.maxX);
        const i32 y = coordinate(random, box.minY, box.maxY);
        ChildJob job = {x, y, id, 0};
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

static int roll_leaf_map(Random *random, JobScene *scene)
{
    int result = job_scene_random(scene, random, 60, 8, 96, 64);
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "leaf map (each leaf of the tree has a colour of its own), 96x64");
    if (result == 0) {
        result = job_scene_grow_tree(scene, (KdTreeLimits){8, 3});
    }
    return result == 0 ? make_leaf_map(scene, FAR_IDS) : -1;
}

// Is a pixel's leaf empty?
static int has_empty_leaf(const JobScene *scene)
{
    const KdTree2D *tree = &scene->tree;
    for (int i = 0; i < scene->scene.width * scene->scene.height; i++) {
        const u32 id = leaf_at(tree, i % scene->scene.width, i / scene->scene.width);
        if (id < tree->n_nodes &&
            tree->mapNode2Circles[tree->nodes_Relations[id].circleMapOffset] == 0) {
            return 1;
        }
    }
    return 0;
}

// An edge case with its tree. Not in all of its sizes has the one with empty leaves any.
static int roll_edge(Random *random, int k, JobScene *scene)
{
    int result;
    do {
        job_scene_free(scene);
        result = job_scene_named(scene, random, edges[k - EDGES].name, 64, 48);
        if (result == 0) {
            result = job_scene_grow_tree(scene, edges[k - EDGES].limits);
        }
    } while (result == 0 && k == EMPTY_LEAVES && !has_empty_leaf(scene));
    return result;
}

// The limits of the tree of scene K.
static KdTreeLimits limits_of(int k)
{
    // The second leaf's list begins where 16 bits do not reach.
    const KdTreeLimits usual = {9, 6}, two_leaves = {2, 1};
    return k == LONG_LIST ? two_leaves : usual;
}

static int roll_scenes(Random *random, JobScene scenes[N_SCENES])
{
    int result = roll_borders(random, &scenes[BORDERS]);
    result |= job_scene_random(&scenes[WIDE], random, 200, 20, WIDE_COLUMNS, WIDE_ROWS);
    result |= roll_within(random, &scenes[WITHIN]);
    result |= roll_leaf_map(random, &scenes[LEAF_MAP]);
    result |= draw_stairs(&scenes[STAIRS]);
    result |= job_scene_random(&scenes[RANDOM], random, 150, 12, 96, 128);
    result |= job_scene_random(&scenes[RANDOM + 1], random, 9, 30, 100, 60);
    job_scene_cover_second(&scenes[RANDOM]);
    job_scene_spread_depths(&scenes[RANDOM + 1]);
    result |= job_scene_named(&scenes[ORDER], random, "equal-depths", 96, 64);
    for (int k = EDGES; k < DEPTHS; k++) {
        result |= roll_edge(random, k, &scenes[k]);
    }
    result |= job_scene_depths(&scenes[DEPTHS], random);
    result |= job_scene_pile(&scenes[LONG_LIST], random);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        if (scenes[k].tree.n_nodes == 0) {
            result = job_scene_grow_tree(&scenes[k], limits_of(k));
        }
        if (result == 0 && k != LEAF_MAP && k != STAIRS) {
            result = job_scene_expect(&scenes[k]);
        }
    }
    return result;
}

// The nodes and inputs of getContainingChild.
static int roll_children(Random *random, Job03 *job)
{
    const KdTree2D *tree = &job->scenes[BORDERS].tree;
    const u32 first = FAR_IDS + N_FAMILY_NODES;
    KdTree2D *nodes = &job->child_tree;
    if (tree_create_03(first + count_sent_nodes_03(job->scenes), 1, nodes) != 0) {
        return -1;
    }
    memcpy(nodes->nodes_Relations, tree->nodes_Relations, tree->n_nodes * sizeof(NodeRel));
    memcpy(nodes->nodes_BBox, tree->nodes_BBox, tree->n_nodes * sizeof(BBox2D));
    for (int i = N_FAMILY_JOBS; i < N_CHILDREN; i++) {
        job->children[i] = roll_child(random, tree, i >= N_INSIDE);
    }
    add_families(nodes, job->children);
    add_sent_03(random, job->scenes, first, nodes, job->children + N_ROLLED_INSIDE,
                job->children + N_INSIDE + N_ROLLED_BORDER);
    return 0;
}

int roll_job_03(void *pointer, Random *random)
{
    Job03 *job = pointer;
    return roll_scenes(random, job->scenes) == 0 ? roll_children(random, job) : -1;
}

void job_03_release(void *pointer)
{
    Job03 *job = pointer;
    tree2d_free(&job->child_tree);
}

int write_child_tree_03(const Job03 *job, FILE *file)
{
    const KdTree2D *tree = &job->child_tree;
    return section_write(file, "children.relations", tree->nodes_Relations,
                         tree->n_nodes * sizeof *tree->nodes_Relations) |
           section_write(file, "children.boxes", tree->nodes_BBox,
                         tree->n_nodes * sizeof *tree->nodes_BBox);
}

int job_03_write_scene(const void *pointer, int k, FILE *file)
{
    const Job03 *job = pointer;
    return (k == 0 ? write_child_tree_03(job, file) : 0) |
           job_scene_write(&job->scenes[k], k, file);
}
