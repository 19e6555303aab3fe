// Judge of lab 02: each function on chosen inputs, and whole trees by their invariants. Read next:
// judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "tree2d_draw.h"
#include "tree_judge.h"

#include <stdlib.h>
#include <string.h>

// Why the builder gave up. If a task's function is to blame, one of its checks tells the reason.
// The other tasks' checks only say that there is no tree.
typedef struct Refusal {
    const char *task;   // whose function did it; NULL when that is not known
    const char *check;  // which tells it
    const char *says;
} Refusal;

static const Refusal too_large = {NULL, NULL, "the tree grows and grows: does splitting ever end?"};
static const Refusal long_child = {"distribute", "tree-lists",
                                   "distribute() returned more circles than the node has"};
static const Refusal long_leaf = {"pack_leaf", "tree-packing",
                                  "pack_leaf() moved n_map by more than the leaf's list is long"};

// Why there is no tree: the builder gave up, or the probe ended before.
static Verdict tree_refused(const char *title, int k, const char *task, const Sections *answers)
{
    const u32 *reason = job_part_find(answers, "tree", k, "refused", sizeof *reason);
    if (reason == NULL) {
        return verdict_missing;
    }
    const Refusal *refusal = *reason == KD_LONG_CHILD  ? &long_child
                             : *reason == KD_LONG_LEAF ? &long_leaf
                                                       : &too_large;
    if (refusal->task != NULL && strcmp(refusal->task, task) != 0) {
        return verdict_of(
            diagnosis_new("%s: kdtree2d_build gave up: see %s", title, refusal->check));
    }
    return verdict_of(refusal->task != NULL
                          ? diagnosis_of(message_new("%s: kdtree2d_build gave up", title),
                                         (Cause){.says = refusal->says})
                          : diagnosis_new("%s: kdtree2d_build gave up: %s", title, refusal->says));
}

static Verdict judge_tree(const void *pointer, int k, const JudgeCheck *check,
                          const Sections *answers)
{
    const JobScene *scene = &((const Job02 *)pointer)->scenes[k];
    KdTree2D own;
    return tree_judge_answer(k, answers, &own)
               ? verdict_of(check->tree2d(scene, &own))
               : tree_refused(scene->picture.title, k, check->task, answers);
}

// ---- The report ---------------------------------------------------------------------------------

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

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"is_leaf-depth", "The last level is leaves", "is_leaf", .function = &is_leaf_02,
     .range = {0, N_LEAVES / 3, 3}},
    {"is_leaf-count", "Few circles make a leaf", "is_leaf", .function = &is_leaf_02,
     .range = {1, N_LEAVES / 3, 3}},
    {"is_leaf-failed", "Failed splits make a leaf", "is_leaf", .function = &is_leaf_02,
     .range = {2, N_LEAVES / 3, 3}},
    {"tree-limits", "Whole trees: leaves where the limits say so", "is_leaf", "*",
     .tree = judge_tree, .tree2d = tree_judge_limits, .range = {0, N_SCENES},
     .replay = &replay_leaf_02},

    {"split-longer", "The longer side is split, x where equal", "split_box",
     .function = &split_longer_02, .range = {0, N_SPLITS}},
    {"split-middle", "In the middle, and nothing else moves", "split_box",
     .function = &split_middle_02, .range = {0, N_SPLITS}},
    {"tree-cells", "Whole trees: children tile their parent", "split_box", "*", .tree = judge_tree,
     .tree2d = tree_judge_cells, .range = {0, N_SCENES}, .replay = &replay_split_02},

    {"overlap-inside", "Circles clearly in and clearly out", "circle_overlaps_box",
     .function = &overlap_02, .range = {0, N_INSIDE}},
    {"overlap-boundary", "Touching counts", "circle_overlaps_box", .function = &overlap_02,
     .range = {N_INSIDE, N_BOUNDARY}},
    {"overlap-corner", "Exact at the corners", "circle_overlaps_box", .function = &overlap_02,
     .range = {N_INSIDE + N_BOUNDARY, N_CORNER}},
    {"tree-overlap", "Whole trees: each leaf has its circles", "circle_overlaps_box", "*",
     .tree = judge_tree, .tree2d = tree_judge_overlap, .range = {0, N_SCENES},
     .replay = &replay_overlap_02},

    {"distribute-list", "The right ids, in order, and how many", "distribute",
     "circle_overlaps_box", .function = &distribute_02, .range = {0, N_DISTRIBUTES},
     .alone = distributes_alone_02},
    {"tree-lists", "Whole trees: lists ascend", "distribute", "*", .tree = judge_tree,
     .tree2d = tree_judge_lists, .range = {0, N_SCENES}, .alone = lists_alone_02},

    {"pack-count", "The list starts with its count", "pack_leaf", .function = &pack_count_02,
     .range = {0, N_PACKS}},
    {"pack-offset", "circleMapOffset points at the count", "pack_leaf", .function = &pack_offset_02,
     .range = {0, N_PACKS}},
    {"pack-rest", "Ids, flag and n_map; nothing else moves", "pack_leaf", .function = &pack_rest_02,
     .range = {0, N_PACKS}},
    {"tree-packing", "Whole trees: packed without gaps", "pack_leaf", "*", .tree = judge_tree,
     .tree2d = tree_judge_packing, .range = {0, N_SCENES}, .alone_scene = packs_alone_02},
};

static void describe_leaf(const void *input, char *words, size_t n_bytes)
{
    const LeafJob *in = input;
    snprintf(words, n_bytes,
             "level %d, %u circles, %d failed splits, maxDepth %d, targetElementsPerNode %d",
             in->level, in->n_circles, in->n_failed, in->maxDepth, in->targetElementsPerNode);
}

static void describe_box(const void *input, char *words, size_t n_bytes)
{
    const BBox2D *box = input;
    snprintf(words, n_bytes, "box x [%g, %g] y [%g, %g]", (double)box->minX, (double)box->maxX,
             (double)box->minY, (double)box->maxY);
}

static void describe_circle_and_box(const void *input, char *words, size_t n_bytes)
{
    const BoxOverlapJob *in = input;
    char box[80];
    describe_box(&in->box, box, sizeof box);
    snprintf(words, n_bytes, "circle at (%g, %g) radius %g, %s", (double)in->circle.x,
             (double)in->circle.y, (double)in->circle.radius, box);
}

static void describe_distribute(const void *input, char *words, size_t n_bytes)
{
    const DistributeJob *in = input;
    snprintf(words, n_bytes, "node with %u circles", in->n_ids);
}

static void describe_pack(const void *input, char *words, size_t n_bytes)
{
    const PackJob *in = input;
    snprintf(words, n_bytes, "leaf with %u circles, map of %u entries", in->n_ids, in->n_before);
}

static const JobPart parts[] = {
    INPUTS("leaves", "is_leaf", Job02, leaves, .describe = describe_leaf),
    INPUTS("splits", "split_box", Job02, splits, .describe = describe_box),
    INPUTS("overlaps", "circle_overlaps_box", Job02, overlaps, .describe = describe_circle_and_box),
    INPUTS("distribute", "distribute", Job02, distributes, .is_apart = 1,
           .describe = describe_distribute),  // alone behind what it needs: write_alone_02()
    INPUTS("pack", "pack_leaf", Job02, packs, .describe = describe_pack),
};

const Judge judge_02 = {
    .lab = "02-kdtree-2d-build",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job02),
    .roll = roll_job_02,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(job_scene_kind, Job02, scenes),
    .scene_steps = {{"tree", "while kdtree2d_build built a whole tree", NULL}},
    .write_scene = job_02_write_scene,
    .write_alone = write_alone_02,
    .add_pictures = add_pictures,
};
