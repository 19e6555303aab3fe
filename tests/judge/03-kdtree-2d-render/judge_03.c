// Judge of lab 03: getContainingChild on chosen inputs, pictures through given trees, counted work.
// Read next: judge_03.h, judge_03_alone.c.
#include "judge_03.h"

#include "job_work.h"
#include "message.h"
#include "packed_list.h"
#include "words.h"

#include <math.h>

// ---- getContainingChild -------------------------------------------------------------------------

// A way to choose: is it the left child? Of the node's cell and the left child's.
typedef int GoesLeft(BBox2D node, BBox2D left, double x, double y);

static int by_inner(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return x > left.minX && x < left.maxX && y > left.minY && y < left.maxY;
}

static int by_inner_x(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return x != left.minX && cell_holds(left, x, y);
}

static int by_inner_y(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return y != left.minY && cell_holds(left, x, y);
}

static int by_border(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return x >= left.minX && x <= left.maxX && y >= left.minY && y <= left.maxY;
}

static int by_middle(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return cell_holds(left, x + 0.5, y + 0.5);
}

static int by_corner(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return cell_holds(left, x - 0.5, y - 0.5);
}

// As whole numbers, like a conversion to int.
static int by_whole(BBox2D node, BBox2D left, double x, double y)
{
    const BBox2D whole = {truncf(left.minX), truncf(left.maxX), truncf(left.minY),
                          truncf(left.maxY)};
    (void)node;
    return cell_holds(whole, x, y);
}

static int by_nearest(BBox2D node, BBox2D left, double x, double y)
{
    const BBox2D whole = {floorf(left.minX + 0.5f), floorf(left.maxX + 0.5f),
                          floorf(left.minY + 0.5f), floorf(left.maxY + 0.5f)};
    (void)node;
    return cell_holds(whole, x, y);
}

// As numbers without a sign, which have no room for negative ones.
static int by_unsigned(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return left.minX >= 0 && left.minY >= 0 && cell_holds(left, x, y);
}

static int by_x(BBox2D node, BBox2D left, double x, double y)
{
    (void)node, (void)y;
    return x >= left.minX && x < left.maxX;
}

static int by_y(BBox2D node, BBox2D left, double x, double y)
{
    (void)node, (void)x;
    return y >= left.minY && y < left.maxY;
}

static int by_copied_x(BBox2D node, BBox2D left, double x, double y)
{
    return by_x(node, left, x, y) && y >= left.minY && y < left.maxX;
}

static int by_copied_y(BBox2D node, BBox2D left, double x, double y)
{
    return x >= left.minX && x < left.maxY && by_y(node, left, x, y);
}

static int by_swapped(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return cell_holds(left, y, x);
}

static int always(BBox2D node, BBox2D left, double x, double y)
{
    (void)node, (void)left, (void)x, (void)y;
    return 1;
}

// The left child where the cell does not hold the pixel.
static int by_the_contrary(BBox2D node, BBox2D left, double x, double y)
{
    (void)node;
    return !cell_holds(left, x, y);
}

#define STRICT                                                                                     \
    {"strict where it should not be: cells are half-open, minX <= x < maxX",                       \
     MISTAKE_STRICT_BOUNDARY}
#define SHIFTED "shifted by half a pixel: the sample point is the integer coordinate"
#define WHOLE_BORDER "a cell's border was made a whole number: it may lie between two pixels"
#define OTHER_AXIS "your answers are those of a comparison with a border of the other axis"
#define ONE_AXIS "your answers are those of one axis alone: there are splits across x and across y"

static const struct {
    GoesLeft *goes_left;
    Cause cause;
} child_mistakes[] = {
    {by_inner, STRICT},
    {by_inner_x, STRICT},
    {by_inner_y, STRICT},
    {by_border, {.says = "cells are half-open: a border belongs to the cell that starts there"}},
    {by_middle, {SHIFTED, MISTAKE_SHIFTED_HALF}},
    {by_corner, {SHIFTED, MISTAKE_SHIFTED_HALF}},
    {by_whole, {.says = WHOLE_BORDER}},
    {by_nearest, {.says = WHOLE_BORDER}},
    {by_unsigned,
     {.says = "your answers are those of numbers without a sign: a cell may begin at negative "
              "coordinates"}},
    {by_x, {.says = ONE_AXIS}},
    {by_y, {.says = ONE_AXIS}},
    {by_copied_x, {.says = OTHER_AXIS}},
    {by_copied_y, {.says = OTHER_AXIS}},
    {by_swapped, {.says = OTHER_AXIS}},
    {by_the_contrary, {.says = "left and right are swapped"}},
    {always,
     {.says = "the left child was chosen every time: its own cell has to hold the pixel, in both "
              "directions"}},
};

// Do all answers, in both checks, follow from this way? Of pixels outside the node's cell either is
// right, and they say nothing.
static int children_follow(const Job03 *job, const u32 *found, GoesLeft *goes_left)
{
    const KdTree2D *tree = &job->child_tree;
    for (int i = 0; i < N_CHILDREN; i++) {
        const ChildJob in = job->children[i];
        const NodeRel node = tree->nodes_Relations[in.id];
        const BBox2D cell = tree->nodes_BBox[in.id];
        const int is_left = goes_left(cell, tree->nodes_BBox[node.lChild], in.x, in.y);
        if (cell_holds(cell, in.x, in.y) && found[i] != (is_left ? node.lChild : node.rChild)) {
            return 0;
        }
    }
    return 1;
}

// Is the answer right? Of a pixel that the node's cell does not hold either child is.
static int is_right_child(const Job03 *job, int i, u32 found)
{
    const KdTree2D *tree = &job->child_tree;
    const ChildJob in = job->children[i];
    const NodeRel node = tree->nodes_Relations[in.id];
    const int is_left = cell_holds(tree->nodes_BBox[node.lChild], in.x, in.y);
    const int is_outside = !cell_holds(tree->nodes_BBox[in.id], in.x, in.y);
    return (found == node.lChild && (is_left || is_outside)) || (found == node.rChild && !is_left);
}

// What may be meant for an epsilon, in pixels.
#define EPSILON 0.125

// How far from a border of the left child does what is wrong stand, at most?
static double farthest_wrong(const Job03 *job, const u32 *found)
{
    const KdTree2D *tree = &job->child_tree;
    double farthest = 0;
    for (int i = 0; i < N_CHILDREN; i++) {
        const ChildJob in = job->children[i];
        const NodeRel node = tree->nodes_Relations[in.id];
        const BBox2D left = tree->nodes_BBox[node.lChild];
        const double to_x = fmin(fabs((double)in.x - left.maxX), fabs((double)in.x - left.minX));
        const double to_y = fmin(fabs((double)in.y - left.maxY), fabs((double)in.y - left.minY));
        if (!is_right_child(job, i, found[i])) {
            farthest = fmax(farthest, fmin(to_x, to_y));
        }
    }
    return farthest;
}

// What wrong children suggest.
static Cause explain_children(const Job03 *job, const u32 *found)
{
    for (int i = 0; i < COUNT(child_mistakes); i++) {
        if (children_follow(job, found, child_mistakes[i].goes_left)) {
            return child_mistakes[i].cause;
        }
    }
    const double farthest = farthest_wrong(job, found);
    return (Cause){
        .says = farthest == 0        ? "pixels exactly on a border are wrong: it belongs to the "
                                       "child with the higher coordinates"
                : farthest < EPSILON ? "your answers are those with an epsilon: none is needed"
                                     : NULL};
}

// A half-open cell.
static Words cell_words(BBox2D box)
{
    return words("x [%.9g, %.9g) y [%.9g, %.9g)", box.minX, box.maxX, box.minY, box.maxY);
}

static Diagnosis child_fault(const void *pointer, int i, const void *answers)
{
    const Job03 *job = pointer;
    const u32 *found = answers;
    const KdTree2D *tree = &job->child_tree;
    const ChildJob in = job->children[i];
    const NodeRel node = tree->nodes_Relations[in.id];
    const BBox2D left = tree->nodes_BBox[node.lChild], right = tree->nodes_BBox[node.rChild];
    const u32 expected = cell_holds(left, in.x, in.y) ? node.lChild : node.rChild;
    if (is_right_child(job, i, found[i])) {
        return NOTHING_WRONG;
    }
    static const Cause no_child = {
        .says = "that is no child of the node, as its lChild and rChild have it"};
    const int is_child = found[i] == node.lChild || found[i] == node.rChild;
    const Cause why = is_child ? explain_children(job, found) : no_child;
    return diagnosis_of(message_new("node %u, pixel (%d, %d): found child %u, expected %u (left "
                                    "child %u is %s, right child %u is %s)",
                                    in.id, in.x, in.y, found[i], expected, node.lChild,
                                    cell_words(left).text, node.rChild, cell_words(right).text),
                        why);
}

static const Function children = {
    .section = "children", .n = N_CHILDREN, .answer_bytes = sizeof(u32), .fault = child_fault};

// ---- Work ---------------------------------------------------------------------------------------

// How many nodes above the leaf: every node whose cell holds the pixel lies on the way.
static u32 steps_to_leaf(const KdTree2D *tree, int x, int y)
{
    u32 steps = 0;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        steps += tree->nodes_flag[id] != LEAF && cell_holds(tree->nodes_BBox[id], x, y);
    }
    return steps;
}

// Is a pixel's work as it should be?
typedef Diagnosis JudgeWork(const JobScene *scene, int x, int y, Work found);

static const char *explain_steps(u32 found, u32 steps)
{
    return steps == 0   ? "the root is a leaf, and there is no step to take"
           : found == 0 ? "either the function was not called, or not with &work: work that is "
                          "hidden cannot be counted"
           : found == 2 * steps ? "it was called twice for each node"
           : found > steps      ? "some nodes were asked more than once"
                                : NULL;
}

static Diagnosis judge_descent(const JobScene *scene, int x, int y, Work found)
{
    const u32 steps = steps_to_leaf(&scene->tree, x, y);
    return found.n_nodes_visited == steps
               ? NOTHING_WRONG
               : diagnosis_of(
                     message_new("%s: pixel (%d, %d): getContainingChild was called %u time%s, "
                                 "expected %u, once for each inner node on the way to the leaf",
                                 scene->picture.title, x, y, found.n_nodes_visited,
                                 plural(found.n_nodes_visited), steps),
                     (Cause){.says = explain_steps(found.n_nodes_visited, steps)});
}

static Cause explain_tests(u32 found, u32 n)
{
    const char *says = found == 0 ? "either the function was not called, or not with &work: work "
                                    "that is hidden cannot be counted"
                       : n == 0   ? "an empty list has no circle to ask"
                       : found == 2 * n ? "each was asked twice"
                       : found > n      ? "some were asked more than once, or circles that are not "
                                          "in the list"
                                        : "circles of the list were not asked";
    const Cause cut = number_cause(found, n);
    return cut.says != NULL ? cut : (Cause){.says = says};
}

static Diagnosis judge_leaf(const JobScene *scene, int x, int y, Work found)
{
    const KdTree2D *tree = &scene->tree;
    const u32 n = tree->mapNode2Circles[tree->nodes_Relations[leaf_at(tree, x, y)].circleMapOffset];
    return found.n_tests == n
               ? NOTHING_WRONG
               : diagnosis_of(message_new("%s: pixel (%d, %d): overlaps_N_Nearer was called %u "
                                          "time%s, but the leaf lists %u circle%s",
                                          scene->picture.title, x, y, found.n_tests,
                                          plural(found.n_tests), n, plural(n)),
                              explain_tests(found.n_tests, n));
}

// Judge the counted work of scene K. In a large picture every seventh pixel each way is plenty: the
// tree is asked node by node. In a small one a leaf may be a few pixels.
static Verdict judge_work(const Job03 *job, int k, JudgeWork *judge_pixel, const Sections *answers)
{
    const JobScene *scene = &job->scenes[k];
    const int width = scene->scene.width, height = scene->scene.height;
    const Work *found = job_work_find(&scene->picture, k, answers);
    Verdict verdict = found == NULL ? verdict_missing : verdict_passed;
    const int step = width * height > 10000 ? 7 : 1;
    for (int y = 0; y < height; y += step) {
        for (int x = 0; verdict.kind == VERDICT_PASSED && x < width; x += step) {
            if (cell_holds(scene->tree.nodes_BBox[0], x, y)) {
                verdict = verdict_of(judge_pixel(scene, x, y, found[y * width + x]));
            }
        }
    }
    return verdict;
}

static Verdict judge_descent_work(const void *job, int k, const Sections *answers)
{
    return judge_work(job, k, judge_descent, answers);
}

// The kernel could write down any count: the leaf map shows whether other leaves' circles were
// asked.
static Verdict judge_leaf_works(const void *job, const Sections *answers)
{
    static const int scenes[] = {WIDE, EMPTY_LEAVES, ROOT_IS_LEAF, LONG_LIST};
    Verdict verdict = verdict_passed;
    for (int i = 0; verdict.kind == VERDICT_PASSED && i < COUNT(scenes); i++) {
        verdict = judge_work(job, scenes[i], judge_leaf, answers);
    }
    return verdict.kind == VERDICT_PASSED ? judge_picture(job, LEAF_MAP, answers) : verdict;
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"child-inside", "Pixels inside one of the children, by however little", "getContainingChild",
     .function = &children, .range = {0, N_INSIDE}},
    {"child-border", "Pixels on a border between children", "getContainingChild",
     .function = &children, .range = {N_INSIDE, N_BORDER}},

    {"descent-picture", "Random scenes through their trees", "descent", "*", .scene = judge_picture,
     .range = {BORDERS, 3}, .alone = all_end_in_leaves_03},
    {"descent-leaf", "Every pixel ends in its own leaf", "descent", "*", .scene = judge_picture,
     .range = {LEAF_MAP, 2}, .alone_scene = ends_in_leaves_03},
    {"descent-work", "One step a level, no more", "descent", "getContainingChild",
     .scene = judge_descent_work, .range = {WIDE, 2, ROOT_IS_LEAF - WIDE}},

    {"leaf-random", "Random scenes", "leaf_loop", "*", .scene = judge_picture,
     .range = {RANDOM, 2}},
    {"leaf-order", "Of equal depths the lower index wins", "leaf_loop", "*", .scene = judge_picture,
     .range = {ORDER, 1}},
    {"leaf-edges", "Empty leaves, long lists, no circles, huge, tiny, any depth", "leaf_loop", "*",
     .scene = judge_picture, .range = {EDGES, N_EDGES}},
    {"leaf-work", "Only the leaf's own circles are asked", "leaf_loop", "*",
     .all = judge_leaf_works},
};

static const JobPart parts[] = {PART("children", "getContainingChild", Job03, children)};

static const ProbeStep steps[] = {
    ON_DEVICE("children", "getContainingChild", ChildJob),
    ON_SCENES("picture", "in implicit2DRenderer_KD", NULL),
};

const Judge judge_03 = {
    .lab = "03-kdtree-2d-render",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job03),
    .roll = roll_job_03,
    .release = job_03_release,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene_kind, Job03, scenes),
    .steps = steps,
    .n_steps = COUNT(steps),
    .write_scene = job_03_write_scene,
    .write_alone = write_alone_03,
    .adopts = 1,
};
