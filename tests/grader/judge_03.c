// Judge of lab 03: getContainingChild on chosen inputs, pictures through given trees, counted work.
#include "judge.h"

#include "job_scene.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "work.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    CHILD_INSIDE,
    CHILD_BORDER,
    DESCENT_PICTURE,
    DESCENT_LEAF,
    DESCENT_WORK,
    LEAF_RANDOM,
    LEAF_ORDER,
    LEAF_EDGES,
    LEAF_WORK,
};

static const Check checks[] = {
    [CHILD_INSIDE] = {"child-inside", "Pixels inside one of the children", "getContainingChild",
                      15},
    [CHILD_BORDER] = {"child-border", "Pixels on a border between children", "getContainingChild",
                      10},
    [DESCENT_PICTURE] = {"descent-picture", "Random scenes through their trees", "descent", 15},
    [DESCENT_LEAF] = {"descent-leaf", "Every pixel ends in its own leaf", "descent", 10},
    [DESCENT_WORK] = {"descent-work", "One step a level, no more", "descent", 10},
    [LEAF_RANDOM] = {"leaf-random", "Random scenes", "leaf_loop", 15},
    [LEAF_ORDER] = {"leaf-order", "Of equal depths the lower index wins", "leaf_loop", 10},
    [LEAF_EDGES] = {"leaf-edges", "Empty leaves, one leaf, no circles, huge, tiny", "leaf_loop",
                    10},
    [LEAF_WORK] = {"leaf-work", "Only the leaf's own circles are asked", "leaf_loop", 5},
};

enum {
    BORDERS = 0,  // root [0, 256] x [0, 256]: splits fall on whole pixels
    WIDE = 1,
    LEAF_MAP = 2,  // each leaf has a colour of its own
    RANDOM = 3,    // two
    ORDER = 5,
    EDGES = 6,
    ROOT_IS_LEAF = EDGES + 4,
    N_EDGES = 6,
    N_SCENES = EDGES + N_EDGES,
};
static const struct {
    const char *name;
    KdTreeLimits limits;
} edges[N_EDGES] = {{"none", {4, 1}}, {"tiny", {8, 1}},     {"outside", {6, 2}},
                    {"huge", {4, 1}}, {"touching", {1, 1}}, {"borders", {7, 2}}};

enum { N_INSIDE = 2000, N_BORDER = 1000 };
enum { N_CHILDREN = N_INSIDE + N_BORDER };

typedef struct Job {
    ChildJob children[N_CHILDREN];
    JobScene scenes[N_SCENES];
    JobPicture *pictures[N_SCENES];  // the scenes'
} Job;

// ---- Drawing the job --------------------------------------------------------------------------

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

static int holds(BBox2D box, double x, double y)
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
        ChildJob job = {coordinate(random, box.minX, box.maxX),
                        coordinate(random, box.minY, box.maxY), id};
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
        fprintf(stderr, "grade: no memory for a scene\n");
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

// The leaf whose cell holds the point, found by asking all of them; the number of nodes when none
// does.
static u32 leaf_at(const KdTree2D *tree, int x, int y)
{
    u32 id = 0;
    while (id < tree->n_nodes &&
           (tree->nodes_flag[id] != LEAF || !holds(tree->nodes_BBox[id], x, y))) {
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

static void job_free(void *pointer)
{
    Job *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene_free(&job->scenes[k]);
    }
    free(job);
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    job_scenes_list(job->scenes, N_SCENES, job->pictures);
    int result = draw_scenes(&random, job->scenes);
    for (int i = 0; result == 0 && i < N_CHILDREN; i++) {
        job->children[i] = draw_child(&random, &job->scenes[BORDERS].tree, i >= N_INSIDE);
    }
    result |= section_write(file, "children", job->children, sizeof job->children);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene_write(&job->scenes[k], k, file);
    }
    if (result != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

// ---- Judging ----------------------------------------------------------------------------------

// A way to decide whether a cell holds a pixel.
typedef int Holds(BBox2D box, double x, double y);

static int holds_inner(BBox2D box, double x, double y)
{
    return x > box.minX && x < box.maxX && y > box.minY && y < box.maxY;
}

static int holds_border(BBox2D box, double x, double y)
{
    return x >= box.minX && x <= box.maxX && y >= box.minY && y <= box.maxY;
}

// Do all answers, in both checks, follow from this way?
static int children_follow(const Job *job, const u32 *found, Holds *way)
{
    const KdTree2D *tree = &job->scenes[BORDERS].tree;
    for (int i = 0; i < N_CHILDREN; i++) {
        const ChildJob in = job->children[i];
        const NodeRel node = tree->nodes_Relations[in.id];
        const int in_left = way(tree->nodes_BBox[node.lChild], in.x, in.y);
        if (found[i] != (in_left ? node.lChild : node.rChild)) {
            return 0;
        }
    }
    return 1;
}

// What wrong children suggest, "" when nothing.
static const char *explain_children(const Job *job, const u32 *found)
{
    if (children_follow(job, found, holds_inner)) {
        return "; strict where it should not be: cells are half-open, minX <= x < maxX";
    }
    if (children_follow(job, found, holds_border)) {
        return "; cells are half-open: a border belongs to the cell that starts there";
    }
    return "";
}

static Verdict judge_children(const Job *job, int first, int n, const Sections *answers)
{
    const u32 *found = sections_find(answers, "children", N_CHILDREN * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    const KdTree2D *tree = &job->scenes[BORDERS].tree;
    for (int i = first; i < first + n; i++) {
        const ChildJob in = job->children[i];
        const NodeRel node = tree->nodes_Relations[in.id];
        const BBox2D left = tree->nodes_BBox[node.lChild], right = tree->nodes_BBox[node.rChild];
        const u32 expected = holds(left, in.x, in.y) ? node.lChild : node.rChild;
        if (found[i] == expected) {
            continue;
        }
        const char *why = found[i] != node.lChild && found[i] != node.rChild
                              ? "; that is no child of the node"
                              : explain_children(job, found);
        return verdict_of(message_new(
            "node %u, pixel (%d, %d): found child %u, expected %u; left child %u is x [%g, %g) y "
            "[%g, %g), right child %u is x [%g, %g) y [%g, %g)%s",
            in.id, in.x, in.y, found[i], expected, node.lChild, (double)left.minX,
            (double)left.maxX, (double)left.minY, (double)left.maxY, node.rChild,
            (double)right.minX, (double)right.maxX, (double)right.minY, (double)right.maxY, why));
    }
    return verdict_of(NULL);
}

// How many nodes above the leaf: every node whose cell holds the pixel lies on the way.
static u32 steps_to_leaf(const KdTree2D *tree, int x, int y)
{
    u32 steps = 0;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        steps += tree->nodes_flag[id] != LEAF && holds(tree->nodes_BBox[id], x, y);
    }
    return steps;
}

// The message when a pixel's work is not as it should be, or NULL.
static char *judge_pixel_work(const JobScene *scene, int check, int x, int y, Work found)
{
    const KdTree2D *tree = &scene->tree;
    if (check == DESCENT_WORK) {
        const u32 steps = steps_to_leaf(tree, x, y);
        return found.n_nodes_visited == steps
                   ? NULL
                   : message_new(
                         "%s: pixel (%d, %d): getContainingChild was called %u times, expected "
                         "%u, once for each inner node on the way to the leaf",
                         scene->picture.title, x, y, found.n_nodes_visited, steps);
    }
    const u32 n = tree->mapNode2Circles[tree->nodes_Relations[leaf_at(tree, x, y)].circleMapOffset];
    return found.n_tests == n
               ? NULL
               : message_new(
                     "%s: pixel (%d, %d): overlaps_N_Nearer was called %u times, but the leaf "
                     "lists %u circles",
                     scene->picture.title, x, y, found.n_tests, n);
}

// Judge the counted work of scene K.
static Verdict judge_scene_work(const JobScene *scene, int k, int check, const Sections *answers)
{
    const int width = scene->scene.width, height = scene->scene.height;
    const size_t n_bytes =
        (size_t)PROBE_IMAGE_SIDE(width) * (size_t)PROBE_IMAGE_SIDE(height) * sizeof(Work);
    const Work *found = job_section_find(answers, "work", k, n_bytes);
    if (found == NULL) {
        if (job_picture_answer(&scene->picture, k, answers).pixels == NULL) {
            return verdict_missing;
        }
        return verdict_of(message_new("the work could not be counted: call getContainingChild and "
                                      "overlaps_N_Nearer in the kernel itself"));
    }
    // Every seventh pixel each way is plenty, and the tree is asked node by node.
    for (int y = 0; y < height; y += 7) {
        for (int x = 0; x < width; x += 7) {
            if (!holds(scene->tree.nodes_BBox[0], x, y)) {
                continue;
            }
            char *message = judge_pixel_work(scene, check, x, y, found[y * width + x]);
            if (message != NULL) {
                return verdict_of(message);
            }
        }
    }
    return verdict_of(NULL);
}

static Verdict judge_work(const Job *job, int check, const Sections *answers)
{
    const int scenes[] = {WIDE, ROOT_IS_LEAF};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        const int k = scenes[i];
        const Verdict verdict = judge_scene_work(&job->scenes[k], k, check, answers);
        if (verdict.kind != VERDICT_PASSED) {
            return verdict;
        }
    }
    return verdict_of(NULL);
}

// The kernel could write down any count: the leaf map shows whether other leaves' circles were
// asked.
static Verdict judge_leaf_work(const Job *job, const Sections *answers)
{
    const Verdict verdict = judge_work(job, LEAF_WORK, answers);
    return verdict.kind == VERDICT_PASSED ? job_pictures_judge(job->pictures, LEAF_MAP, 1, answers)
                                          : verdict;
}

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job *job = pointer;
    switch (check) {
    case CHILD_INSIDE:
        return judge_children(job, 0, N_INSIDE, answers);
    case CHILD_BORDER:
        return judge_children(job, N_INSIDE, N_BORDER, answers);
    case DESCENT_PICTURE:
        return job_pictures_judge(job->pictures, BORDERS, 2, answers);
    case DESCENT_LEAF:
        return job_pictures_judge(job->pictures, LEAF_MAP, 1, answers);
    case DESCENT_WORK:
        return judge_work(job, check, answers);
    case LEAF_WORK:
        return judge_leaf_work(job, answers);
    case LEAF_RANDOM:
        return job_pictures_judge(job->pictures, RANDOM, 2, answers);
    case LEAF_ORDER:
        return job_pictures_judge(job->pictures, ORDER, 1, answers);
    default:
        return job_pictures_judge(job->pictures, EDGES, N_EDGES, answers);
    }
}

static void adopt(void *pointer, const Sections *answers)
{
    Job *job = pointer;
    job_pictures_adopt(job->pictures, N_SCENES, answers);
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job *job = pointer;
    job_pictures_report(job->pictures, N_SCENES, answers, result);
}

const Judge judge_03 = {
    "03-kdtree-2d-render", checks, sizeof checks / sizeof *checks, job_new, job_free, judge, adopt,
    add_pictures,
};
