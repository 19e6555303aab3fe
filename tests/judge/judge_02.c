// Judge of lab 02: each function on chosen inputs, and whole trees by their invariants. Read next:
// judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "tree2d_draw.h"
#include "tree_judge.h"

#include <stdlib.h>
#include <string.h>

static const Check checks[] = {
    [IS_LEAF_DEPTH] = {"is_leaf-depth", "The last level is leaves", "is_leaf", 4},
    [IS_LEAF_COUNT] = {"is_leaf-count", "Few circles make a leaf", "is_leaf", 4},
    [IS_LEAF_FAILED] = {"is_leaf-failed", "Failed splits make a leaf", "is_leaf", 3},
    [TREE_LIMITS] = {"tree-limits", "Whole trees: leaves where the limits say so", "is_leaf", 4,
                     "*"},
    [SPLIT_LONGER] = {"split-longer", "The longer side is split, x where equal", "split_box", 8},
    [SPLIT_MIDDLE] = {"split-middle", "In the middle, and nothing else moves", "split_box", 7},
    [TREE_CELLS] = {"tree-cells", "Whole trees: children tile their parent", "split_box", 5, "*"},
    [OVERLAP_INSIDE] = {"overlap-inside", "Circles clearly in and clearly out",
                        "circle_overlaps_box", 8},
    [OVERLAP_BOUNDARY] = {"overlap-boundary", "Touching counts", "circle_overlaps_box", 6},
    [OVERLAP_CORNER] = {"overlap-corner", "Exact at the corners", "circle_overlaps_box", 6},
    [TREE_OVERLAP] = {"tree-overlap", "Whole trees: each leaf has its circles",
                      "circle_overlaps_box", 5, "*"},
    [DISTRIBUTE_LIST] = {"distribute-list", "The right ids, in order, and how many", "distribute",
                         15, "circle_overlaps_box"},
    [TREE_LISTS] = {"tree-lists", "Whole trees: lists ascend", "distribute", 5, "*"},
    [PACK_COUNT] = {"pack-count", "The list starts with its count", "pack_leaf", 6},
    [PACK_OFFSET] = {"pack-offset", "circleMapOffset points at the count", "pack_leaf", 6},
    [PACK_REST] = {"pack-rest", "Ids, flag and n_map; nothing else moves", "pack_leaf", 3},
    [TREE_PACKING] = {"tree-packing", "Whole trees: packed without gaps", "pack_leaf", 5, "*"},
};

// Why the builder gave up. Of what a task's function did the checks of the others say no more than
// that there is no tree.
typedef struct Refusal {
    const char *task;   // whose function did it; NULL when that is not known
    const char *check;  // which says it
    const char *says;
} Refusal;

static const Refusal refusals[N_TREE_REFUSALS] = {
    [TREE_TOO_LARGE] = {NULL, NULL, "the tree grows and grows: does splitting ever end?"},
    [TREE_OF_TOO_MANY_IDS] = {"distribute", "tree-lists",
                              "distribute() returned more circles than the node has"},
    [TREE_OF_LONG_LISTS] = {"pack_leaf", "tree-packing",
                            "pack_leaf() moved n_map by more than the leaf's list is long"},
};

// Why there is no tree: the builder gave up, or the probe ended before.
static Verdict tree_refused(const JobScene *scene, int k, int check, const Sections *answers)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "tree.%d.refused", k);
    const u32 *reason = sections_find(answers, name, sizeof *reason);
    if (reason == NULL) {
        return verdict_missing;
    }
    const Refusal *refusal = &refusals[*reason < N_TREE_REFUSALS ? *reason : TREE_TOO_LARGE];
    const char *title = scene->picture.title;
    if (refusal->task != NULL && strcmp(refusal->task, checks[check].task) != 0) {
        return verdict_of(message_new("%s: kdtree2d_build gave up: see %s", title, refusal->check));
    }
    return verdict_of(message_new("%s: kdtree2d_build gave up%s%s", title,
                                  refusal->task ? MESSAGE_CAUSE : ": ", refusal->says));
}

static Verdict judge_trees(const Job02 *job, int check, const Sections *answers,
                           char *(*judge_one)(const JobScene *, const KdTree2D *))
{
    for (int k = 0; k < N_SCENES; k++) {
        KdTree2D own;
        if (!tree_judge_answer(k, answers, &own)) {
            return tree_refused(&job->scenes[k], k, check, answers);
        }
        char *message = judge_one(&job->scenes[k], &own);
        if (message != NULL) {
            return verdict_of(message);
        }
    }
    return verdict_of(NULL);
}

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job02 *job = pointer;
    switch (check) {
    case IS_LEAF_DEPTH:
        return judge_02_is_leaf(job, 0, answers);
    case IS_LEAF_COUNT:
        return judge_02_is_leaf(job, 1, answers);
    case IS_LEAF_FAILED:
        return judge_02_is_leaf(job, 2, answers);
    case TREE_LIMITS:
        return judge_trees(job, check, answers, tree_judge_limits);
    case SPLIT_LONGER:
    case SPLIT_MIDDLE:
        return judge_02_split(job, check, answers);
    case TREE_CELLS:
        return judge_trees(job, check, answers, tree_judge_cells);
    case OVERLAP_INSIDE:
        return judge_02_overlaps(job, 0, N_INSIDE, answers);
    case OVERLAP_BOUNDARY:
        return judge_02_overlaps(job, N_INSIDE, N_BOUNDARY, answers);
    case OVERLAP_CORNER:
        return judge_02_overlaps(job, N_INSIDE + N_BOUNDARY, N_CORNER, answers);
    case TREE_OVERLAP:
        return judge_trees(job, check, answers, tree_judge_overlap);
    case DISTRIBUTE_LIST:
        return judge_02_distribute(job, answers);
    case TREE_LISTS:
        return judge_trees(job, check, answers, tree_judge_lists);
    case PACK_COUNT:
    case PACK_OFFSET:
    case PACK_REST:
        return judge_02_pack(job, check, answers);
    default:
        return judge_trees(job, check, answers, tree_judge_packing);
    }
}

static int passes_alone(const void *pointer, int check, const Sections *answers)
{
    if (checks[check].needs != NULL) {
        return judge_02_passes_alone(pointer, check, answers);
    }
    return verdict_passes(judge(pointer, check, answers));
}

static void adopt(void *pointer, const Sections *answers)
{
    // The oracle's trees stay the reference; nothing is drawn on the device.
    (void)pointer, (void)answers;
}

// A tree as SVG text, or NULL.
static char *svg_of(const Scene2D *scene, const KdTree2D *tree)
{
    char *text = NULL;
    size_t n_bytes = 0;
    FILE *file = open_memstream(&text, &n_bytes);
    if (file == NULL) {
        return NULL;
    }
    const int result = tree2d_write_svg(file, scene, tree);
    fclose(file);
    if (result != 0) {
        free(text);
        return NULL;
    }
    return text;
}

// A submission's tree may have more nodes than these, but a report of many megabytes helps nobody.
enum { MAX_DRAWN_NODES = 20000 };

// The example's tree and the first random one.
static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job02 *job = pointer;
    for (int k = 1; k >= 0 && result->n_pictures < RESULT_MAX_PICTURES; k--) {
        PictureResult *picture = &result->pictures[result->n_pictures++];
        KdTree2D own;
        snprintf(picture->title, sizeof picture->title, "tree over %s",
                 job->scenes[k].picture.title);
        picture->svg_reference = svg_of(&job->scenes[k].scene, &job->scenes[k].tree);
        if (tree_judge_answer(k, answers, &own) && own.n_nodes <= MAX_DRAWN_NODES) {
            picture->svg_own = svg_of(&job->scenes[k].scene, &own);
        }
    }
}

const Judge judge_02 = {
    .lab = "02-kdtree-2d-build",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_02_new,
    .job_free = job_02_free,
    .judge = judge,
    .write_alone = judge_02_write_alone,
    .passes_alone = passes_alone,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
