// Judge of lab 03: getContainingChild on chosen inputs, pictures through given trees. Read next:
// judge_03.h, judge_03_work.c, judge_03_alone.c.
#include "judge_03.h"

#include "message.h"
#include "picture_looks.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>

// ---- getContainingChild -------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const KdTree2D *tree = &((const Job03 *)job)->child_tree;                                      \
    const ChildJob in = ((const Job03 *)job)->children[i];                                         \
    const NodeRel node = tree->nodes_Relations[in.first + in.id];                                  \
    const BBox2D *boxes = tree->nodes_BBox + in.first;                                             \
    const BBox2D cell = boxes[in.id], left = boxes[node.lChild];                                   \
    const u32 found = ((const u32 *)answers)[i];                                                   \
    (void)cell, (void)left
// Of a pixel that the node's cell does not hold either child is right.
#define IS_FOUND(is_left)                                                                          \
    ((found == node.lChild || found == node.rChild) &&                                             \
     (!cell_holds(cell, in.x, in.y) || (found == node.lChild) == (is_left)))

RIGHT(is_right_child, IS_FOUND(cell_holds(left, in.x, in.y)))

// With other numbers for the left child's borders.
static BBox2D rounded(BBox2D box, float (*to)(float))
{
    return (BBox2D){to(box.minX), to(box.maxX), to(box.minY), to(box.maxY)};
}

static float nearest(float value)
{
    return floorf(value + 0.5f);
}

#define STRICT                                                                                     \
    "strict where it should not be: cells are half-open, minX <= x < maxX", MISTAKE_STRICT_BOUNDARY
#define SHIFTED                                                                                    \
    "shifted by half a pixel: the sample point is the integer coordinate", MISTAKE_SHIFTED_HALF
#define WHOLE_BORDER "a cell's border was made a whole number: it may lie between two pixels"
#define OTHER_AXIS "your answers are those of a comparison with a border of the other axis"
#define ONE_AXIS "your answers are those of one axis alone: there are splits across x and across y"

// Other numbers in one of the comparisons with maxX and maxY, or in that with minX or minY, too.
#define COMPARED(name, x_, X, y_, Y)                                                               \
    ANSWERS(name,                                                                                  \
            in.x_ >= left.min##X && in.x_ < left.max##X && in.y_ >= left.min##Y &&                 \
                in.y_ < left.max##Y,                                                               \
            OTHER_AXIS);                                                                           \
    ANSWERS(name##_below, in_min &&in.x_ < left.max##X && in.y_ < left.max##Y, OTHER_AXIS);        \
    ANSWERS(name##_above, in.x_ >= left.min##X && in.y_ >= left.min##Y && in_min && in_max,        \
            OTHER_AXIS)

// How far the pixel is from a border of the left child, and what may be meant for an epsilon.
#define EPSILON 0.125

KNOWN_LIST(known)
{
    GIVEN;
    const int in_min = in.x >= left.minX && in.y >= left.minY;
    const int in_max = in.x < left.maxX && in.y < left.maxY;
    const int in_x = in.x >= left.minX && in.x < left.maxX;
    const int in_y = in.y >= left.minY && in.y < left.maxY;
    const double to_x = fmin(fabs((double)in.x - left.maxX), fabs((double)in.x - left.minX));
    const double to_y = fmin(fabs((double)in.y - left.maxY), fabs((double)in.y - left.minY));

    ANSWERS(inner, cell_holds(left, in.x, in.y) && in.x != left.minX && in.y != left.minY, STRICT);
    ANSWERS(inner_x, cell_holds(left, in.x, in.y) && in.x != left.minX, STRICT);
    ANSWERS(inner_y, cell_holds(left, in.x, in.y) && in.y != left.minY, STRICT);
    ANSWERS(border,
            in.x >= left.minX && in.x <= left.maxX && in.y >= left.minY && in.y <= left.maxY,
            "cells are half-open: a border belongs to the cell that starts there");
    ANSWERS(middle, cell_holds(left, in.x + 0.5, in.y + 0.5), SHIFTED);
    ANSWERS(corner, cell_holds(left, in.x - 0.5, in.y - 0.5), SHIFTED);
    ANSWERS(middle_x, cell_holds(left, in.x + 0.5, in.y), SHIFTED);
    ANSWERS(middle_y, cell_holds(left, in.x, in.y + 0.5), SHIFTED);
    ANSWERS(cut_borders, cell_holds(rounded(left, truncf), in.x, in.y), WHOLE_BORDER);
    ANSWERS(cut_max_x, in_min && in.x < truncf(left.maxX) && in.y < left.maxY, WHOLE_BORDER);
    ANSWERS(cut_max_y, in_min && in.x < left.maxX && in.y < truncf(left.maxY), WHOLE_BORDER);
    ANSWERS(cut_max, in_min && in.x < truncf(left.maxX) && in.y < truncf(left.maxY), WHOLE_BORDER);
    ANSWERS(rounded_borders, cell_holds(rounded(left, nearest), in.x, in.y), WHOLE_BORDER);
    ANSWERS(no_sign, left.minX >= 0 && left.minY >= 0 && cell_holds(left, in.x, in.y),
            "your answers are those of numbers without a sign: a cell may begin at negative "
            "coordinates");
#define IN_MIDDLE                                                                                  \
    "the border was put into the middle of the cell: the cells of its children say where it is"
    ANSWERS(by_middle,
            cell.maxX - cell.minX >= cell.maxY - cell.minY
                ? in.x < ((double)cell.minX + cell.maxX) / 2
                : in.y < ((double)cell.minY + cell.maxY) / 2,
            IN_MIDDLE);
#define TURNED                                                                                     \
    "your answers are those of a comparison the wrong way round, or with the wrong border: the "   \
    "left child's cell is from minX to maxX, and from minY to maxY"
    ANSWERS(x_alone, in_x, ONE_AXIS);
    ANSWERS(y_alone, in_y, ONE_AXIS);
    COMPARED(y_to_x, x, X, y, X);
    COMPARED(x_to_y, x, Y, y, Y);
    COMPARED(x_for_y, x, X, x, Y);
    COMPARED(y_for_x, y, X, y, Y);
    COMPARED(swapped_axes, y, X, x, Y);
    ANSWERS(by_min, in.x < left.minX && in.y < left.minY, TURNED);
    // At maxX, or maxY, itself either answer may be meant.
    EACH(above_max_x, in.x == left.maxX || IS_FOUND(in_y && in.x > left.maxX), TURNED);
    EACH(above_max_y, in.y == left.maxY || IS_FOUND(in_x && in.y > left.maxY), TURNED);
    ANSWERS(always_right, 0, TURNED);
    ANSWERS(contrary, !cell_holds(left, in.x, in.y), "left and right are swapped");
    ANSWERS(always_left, 1,
            "the left child was chosen every time: its own cell has to hold the pixel, in both "
            "directions");

    EACH(is_side, found <= 1,
         "0 and 1 are no ids of its children: return its lChild or its rChild");

    ONLY(no_child, found != node.lChild && found != node.rChild,
         "that is no child of the node, as its lChild and rChild have it");
    ONLY(on_border, to_x == 0 || to_y == 0,
         "pixels exactly on a border are wrong: it belongs to the child with the higher "
         "coordinates");
    ONLY(near_border, to_x < EPSILON || to_y < EPSILON,
         "your answers are those with an epsilon: none is needed");
    return NO_MORE;
}

// A half-open cell.
static Words cell_words(BBox2D box)
{
    return words("x [%.9g, %.9g) y [%.9g, %.9g)", box.minX, box.maxX, box.minY, box.maxY);
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("node %u, pixel (%d, %d): your code goes on with node %u, expected %u (left "
                       "child %u is %s, right child %u is %s)",
                       in.id, in.x, in.y, found,
                       cell_holds(left, in.x, in.y) ? node.lChild : node.rChild, node.lChild,
                       cell_words(left).text, node.rChild, cell_words(boxes[node.rChild]).text);
}

static const Function children = {"children", N_CHILDREN, sizeof(u32),
                                  KNOWING(is_right_child, describe, known), .knows_constant = 1};

// ---- Leaf maps ----------------------------------------------------------------------------------

// The picture of a descent. What is known of scenes are mistakes with circles and lists; a way that
// leads elsewhere may look like one of them, and is none.
static Verdict judge_way(const void *job, int k, const Sections *answers)
{
    const JobPicture *picture = job_picture(job, k);
    const ProbeImage own = job_picture_answer(picture, k, answers);
    Verdict verdict = judge_picture(job, k, answers);
    if (verdict.kind == VERDICT_FAILED && verdict.diagnosis.cause != NULL) {
        const Evidence evidence = verdict.diagnosis.evidence;
        char *found = message_new("%s", verdict.diagnosis.found);
        diagnosis_free(&verdict.diagnosis);
        verdict = verdict_of(
            diagnosis_seen(found, picture_distortion(own, &picture->expected), evidence));
    }
    return verdict;
}

// A leaf map in the numbers of its nodes, where the picture has the colours of two.
static Verdict judge_leaf_map(const void *job, int k, const Sections *answers)
{
    const JobScene *scene = &((const Job03 *)job)->scenes[k];
    Verdict verdict = judge_picture(job, k, answers);
    char *ends = verdict.kind == VERDICT_FAILED ? first_wrong_end_03(scene, k, answers) : NULL;
    if (ends != NULL) {
        char *found = message_new("%s, %s", verdict.diagnosis.found, ends);
        free(verdict.diagnosis.found);
        verdict.diagnosis.found = found;
    }
    free(ends);
    return verdict;
}

// Does a pixel of the leaf map show a circle that the function takes nowhere?
static int shows_untaken(const Job03 *job, const Sections *answers)
{
    const JobPicture *picture = &job->scenes[LEAF_MAP].picture;
    const ProbeImage own = job_picture_answer(picture, LEAF_MAP, answers);
    int i = 0;
    while (own.pixels != NULL && i < expected_n_pixels(&picture->expected) &&
           pixel_pair(own, &picture->expected, i).own[IMAGE_CHANNELS - 1] != UNTAKEN) {
        i++;
    }
    return own.pixels != NULL && i < expected_n_pixels(&picture->expected);
}

// The kernel could write down any count: the leaf map shows whether other leaves' circles were
// asked, and whether they were tested by the function.
static Verdict judge_leaf_works(const void *job, const Sections *answers)
{
    Verdict verdict = judge_leaf_work_03(job, answers);
    if (verdict.kind == VERDICT_PASSED) {
        verdict = judge_picture(job, LEAF_MAP, answers);
    }
    if (verdict.kind == VERDICT_FAILED && shows_untaken(job, answers)) {
        char *found = verdict.diagnosis.found;
        verdict.diagnosis.found = NULL;
        diagnosis_free(&verdict.diagnosis);
        verdict.diagnosis = diagnosis_of(
            found, (Cause){.says = "circles were tested without a call of overlaps_N_Nearer"});
    }
    return verdict;
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"child-inside", "Pixels inside one of the children, by however little", "getContainingChild",
     .function = &children, .range = {0, N_INSIDE}},
    {"child-border", "Pixels on a border between children", "getContainingChild",
     .function = &children, .range = {N_INSIDE, N_BORDER}},

    {"descent-picture", "Random scenes through their trees", "descent", "*", .scene = judge_way,
     .range = {0, LEAF_MAP}, .alone_scene = ends_in_leaves_03},
    {"descent-leaf", "Every pixel ends in its own leaf", "descent", "*", .scene = judge_leaf_map,
     .range = {LEAF_MAP, 2}, .alone_scene = ends_in_leaves_03, .alone_cause = descent_cause_03},
    {"descent-work", "One step a level, no more", "descent", "getContainingChild",
     .all = judge_descent_work_03},

    {"leaf-random", "Random scenes", "leaf_loop", "*", .scene = judge_picture, .range = {0, ORDER}},
    {"leaf-order", "Of equal depths the lower index wins", "leaf_loop", "*", .scene = judge_picture,
     .range = {ORDER, 1}},
    {"leaf-edges", "Empty leaves, long lists, no circles, huge, tiny, any depth", "leaf_loop", "*",
     .scene = judge_picture, .range = {EDGES, N_SCENES - EDGES}},
    {"leaf-work", "Only the leaf's own circles are asked", "leaf_loop", "*",
     .all = judge_leaf_works},
};

static const JobPart parts[] = {INPUTS("children", "getContainingChild", Job03, children)};

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
    .scene_steps = {{"picture", "in implicit2DRenderer_KD", NULL}},
    .write_scene = job_03_write_scene,
    .write_alone = write_alone_03,
    .adopts = 1,
};
