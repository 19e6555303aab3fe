// Judge of lab 03: getContainingChild on chosen inputs, pictures through given trees, counted work.
// Read next: judge_03.h, judge_03_alone.c.
#include "judge_03.h"

#include "job_sections.h"
#include "message.h"
#include "work.h"

#include <stdlib.h>

static const Check checks[] = {
    [CHILD_INSIDE] = {"child-inside", "Pixels inside one of the children", "getContainingChild",
                      15},
    [CHILD_BORDER] = {"child-border", "Pixels on a border between children", "getContainingChild",
                      10},
    [DESCENT_PICTURE] = {"descent-picture", "Random scenes through their trees", "descent", 15,
                         "*"},
    [DESCENT_LEAF] = {"descent-leaf", "Every pixel ends in its own leaf", "descent", 10, "*"},
    [DESCENT_WORK] = {"descent-work", "One step a level, no more", "descent", 10,
                      "getContainingChild"},
    [LEAF_RANDOM] = {"leaf-random", "Random scenes", "leaf_loop", 15, "*"},
    [LEAF_ORDER] = {"leaf-order", "Of equal depths the lower index wins", "leaf_loop", 10, "*"},
    [LEAF_EDGES] = {"leaf-edges", "Empty leaves, one leaf, no circles, huge, tiny", "leaf_loop", 10,
                    "*"},
    [LEAF_WORK] = {"leaf-work", "Only the leaf's own circles are asked", "leaf_loop", 5, "*"},
};

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
static int children_follow(const Job03 *job, const u32 *found, Holds *way)
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
static const char *explain_children(const Job03 *job, const u32 *found)
{
    if (children_follow(job, found, holds_inner)) {
        return "; strict where it should not be: cells are half-open, minX <= x < maxX";
    }
    if (children_follow(job, found, holds_border)) {
        return "; cells are half-open: a border belongs to the cell that starts there";
    }
    return "";
}

static Verdict judge_children(const Job03 *job, int first, int n, const Sections *answers)
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
        const u32 expected = cell_holds(left, in.x, in.y) ? node.lChild : node.rChild;
        if (found[i] == expected) {
            continue;
        }
        const char *why = found[i] != node.lChild && found[i] != node.rChild
                              ? "; that is no child of the node"
                              : explain_children(job, found);
        return verdict_of(message_new(
            "node %u, pixel (%d, %d): found child %u, expected %u (left child %u is x [%g, %g) y "
            "[%g, %g), right child %u is x [%g, %g) y [%g, %g))%s",
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
        steps += tree->nodes_flag[id] != LEAF && cell_holds(tree->nodes_BBox[id], x, y);
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
        return verdict_of(message_new("the work could not be counted; call getContainingChild and "
                                      "overlaps_N_Nearer in the kernel itself"));
    }
    // Every seventh pixel each way is plenty, and the tree is asked node by node.
    for (int y = 0; y < height; y += 7) {
        for (int x = 0; x < width; x += 7) {
            if (!cell_holds(scene->tree.nodes_BBox[0], x, y)) {
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

static Verdict judge_work(const Job03 *job, int check, const Sections *answers)
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
static Verdict judge_leaf_work(const Job03 *job, const Sections *answers)
{
    const Verdict verdict = judge_work(job, LEAF_WORK, answers);
    return verdict.kind == VERDICT_PASSED ? job_pictures_judge(job->pictures, LEAF_MAP, 1, answers)
                                          : verdict;
}

Verdict judge_03_check(const void *pointer, int check, const Sections *answers)
{
    const Job03 *job = pointer;
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
    Job03 *job = pointer;
    job_pictures_adopt(job->pictures, N_SCENES, answers);
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job03 *job = pointer;
    job_pictures_report(job->pictures, N_SCENES, answers, result);
}

const Judge judge_03 = {
    .lab = "03-kdtree-2d-render",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_03_new,
    .job_free = job_03_free,
    .judge = judge_03_check,
    .write_alone = alone_03_write,
    .passes_alone = alone_03_passes,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
