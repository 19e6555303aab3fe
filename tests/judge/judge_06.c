// Judge of lab 06: its checks, and whole trees by their invariants. The functions by themselves are
// judged in judge_06_functions.c.
#include "judge_06.h"
#include "message.h"
#include "tree3d_draw.h"

#include <stdlib.h>
#include <string.h>

static const Check checks[] = {
    [SPLIT_AXIS] = {"split-axis", "The longest side, the first where equal", "choose_split", 12},
    [SPLIT_MIDDLE] = {"split-middle", "In the middle", "choose_split", 9},
    [TREE_SPLITS] = {"tree-splits", "Whole trees: each plane halves its cell", "choose_split", 9,
                     "*"},
    [OVERLAP_INSIDE] = {"overlap-inside", "Spheres clearly in and clearly out",
                        "sphere_overlaps_box", 8},
    [OVERLAP_TOUCHING] = {"overlap-touching", "Touching counts", "sphere_overlaps_box", 7},
    [OVERLAP_CORNER] = {"overlap-corner", "Exact at edges and corners", "sphere_overlaps_box", 9},
    [TREE_OVERLAP] = {"tree-overlap", "Whole trees: each leaf has its spheres",
                      "sphere_overlaps_box", 6, "*"},
    [PACK_NODE] = {"pack-node", "The node says where its spheres are", "pack_leaf_range", 12},
    [PACK_IDS] = {"pack-ids", "The ids, one behind the other", "pack_leaf_range", 9},
    [TREE_PACKING] = {"tree-packing", "Whole trees: packed without gaps", "pack_leaf_range", 9,
                      "*"},
    [FITS_LEVELS] = {"fits-levels", "Level by level", "fits_todo", 6},
    [TREE_DEPTH] = {"tree-depth", "Whole trees: too deep ones are refused, others built",
                    "fits_todo", 4, "*"},
};

// ---- Judging whole trees ----------------------------------------------------------------------

static int is_refused(int k, const Sections *answers)
{
    char name[32];  // room for any K
    snprintf(name, sizeof name, "tree.%d.refused", k);
    return sections_find(answers, name, 0) != NULL;
}

// The message when the root is neither a leaf nor has children, or NULL. Who walks down such a tree
// meets no leaf and comes no level deeper: nothing is wrong there, but nothing is right.
static char *judge_root(const TreeScene3D *scene, const KdTree3D *own)
{
    const KdNode3 root = own->nodes[0];
    const int has_children = root.split_axis < KD_LEAF && root.first > 0 && own->n_nodes > 2 &&
                             root.first <= own->n_nodes - 2;
    if (root.split_axis == KD_LEAF || has_children) {
        return NULL;
    }
    return message_new("%s: node 0, the root: split_axis is %u and first %u of %u nodes, expected "
                       "KD_LEAF (%d), or an axis and its children: no search comes to a leaf",
                       scene->title, root.split_axis, root.first, own->n_nodes, KD_LEAF);
}

// The scene's box and the lists are given; but a tree is no good without them.
static char *judge_splits(const TreeScene3D *scene, const KdTree3D *own)
{
    char *message = tree3d_judge_bounds(scene, own);
    return message != NULL ? message : tree3d_judge_splits(scene, own);
}

static char *judge_overlap(const TreeScene3D *scene, const KdTree3D *own)
{
    char *message = judge_root(scene, own);
    message = message != NULL ? message : tree3d_judge_overlap(scene, own);
    return message != NULL ? message : tree3d_judge_lists(scene, own);
}

static char *judge_depth(const TreeScene3D *scene, const KdTree3D *own)
{
    char *message = judge_root(scene, own);
    return message != NULL ? message : tree3d_judge_depth(scene, own);
}

// Judge scene K's tree, which there must be.
static Verdict judge_tree(const TreeScene3D *scene, int k, const Sections *answers,
                          char *(*judge_one)(const TreeScene3D *, const KdTree3D *))
{
    KdTree3D own = {0};
    if (is_refused(k, answers)) {
        return verdict_of(message_new("%s, maxDepth %d: kdtree3d_build gave up, expected a tree of "
                                      "%u nodes: does splitting ever end, and does fits_todo() "
                                      "allow it?",
                                      scene->title, scene->limits.maxDepth, scene->tree.n_nodes));
    }
    if (tree3d_judge_answer(k, answers, &own)) {
        return verdict_of(judge_one(scene, &own));
    }
    if (own.n_nodes > TREE3D_ANSWER_NODES || own.n_sphere_ids > TREE3D_ANSWER_IDS) {
        return verdict_of(message_new("%s, maxDepth %d: the tree has %u nodes and %u ids, expected "
                                      "%u and %u",
                                      scene->title, scene->limits.maxDepth, own.n_nodes,
                                      own.n_sphere_ids, scene->tree.n_nodes,
                                      scene->tree.n_sphere_ids));
    }
    return verdict_missing;
}

static Verdict judge_trees(const Job06 *job, const Sections *answers,
                           char *(*judge_one)(const TreeScene3D *, const KdTree3D *))
{
    for (int k = 0; k <= JUST_FITS; k++) {
        if (k == JUST_FITS && is_refused(k, answers)) {
            break;  // for fits_todo() to answer for: see judge_depths()
        }
        const Verdict verdict = judge_tree(&job->scenes[k], k, answers, judge_one);
        if (verdict.kind != VERDICT_PASSED) {
            return verdict;
        }
    }
    return verdict_of(NULL);
}

static Verdict judge_depths(const Job06 *job, const Sections *answers)
{
    const Verdict verdict = judge_tree(&job->scenes[JUST_FITS], JUST_FITS, answers, judge_depth);
    if (verdict.kind != VERDICT_PASSED || is_refused(TOO_DEEP, answers)) {
        return verdict;
    }
    return judge_tree(&job->scenes[TOO_DEEP], TOO_DEEP, answers, judge_depth);
}

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job06 *job = pointer;
    switch (check) {
    case SPLIT_AXIS:
    case SPLIT_MIDDLE:
        return judge_06_splits(job, check, answers);
    case TREE_SPLITS:
        return judge_trees(job, answers, judge_splits);
    case OVERLAP_INSIDE:
        return judge_06_overlaps(job, 0, N_INSIDE, answers);
    case OVERLAP_TOUCHING:
        return judge_06_overlaps(job, N_INSIDE, N_TOUCHING, answers);
    case OVERLAP_CORNER:
        return judge_06_overlaps(job, N_INSIDE + N_TOUCHING, N_CORNER, answers);
    case TREE_OVERLAP:
        return judge_trees(job, answers, judge_overlap);
    case PACK_NODE:
    case PACK_IDS:
        return judge_06_pack(job, check, answers);
    case TREE_PACKING:
        return judge_trees(job, answers, tree3d_judge_packing);
    case FITS_LEVELS:
        return judge_06_fits(answers);
    default:
        return judge_depths(job, answers);
    }
}

static int passes_alone(const void *pointer, int check, const Sections *answers)
{
    if (checks[check].needs != NULL) {
        return judge_06_passes_alone(pointer, check, answers);
    }
    return verdict_passes(judge(pointer, check, answers));
}

static void adopt(void *pointer, const Sections *answers)
{
    // The oracle's trees stay the reference; nothing is drawn on the device.
    (void)pointer, (void)answers;
}

// ---- The report -------------------------------------------------------------------------------

// Cuts through the first tree and through one that small spheres make deep.
static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    static const int drawn[] = {0, 2};
    const Job06 *job = pointer;
    for (int i = 0; i < 2 && result->n_pictures < RESULT_MAX_PICTURES; i++) {
        const TreeScene3D *scene = &job->scenes[drawn[i]];
        PictureResult *picture = &result->pictures[result->n_pictures++];
        KdTree3D own;
        snprintf(picture->title, sizeof picture->title, "cut through the tree over %s",
                 scene->title);
        tree3d_draw(&scene->scene, &scene->tree, &picture->reference);
        // Only what is packed as it should be can be followed. Lists do not matter to a drawing.
        if (!is_refused(drawn[i], answers) && tree3d_judge_answer(drawn[i], answers, &own)) {
            char *unfit = tree3d_judge_packing(scene, &own);
            if (unfit == NULL) {
                tree3d_draw(&scene->scene, &own, &picture->own);
            }
            free(unfit);
        }
    }
}

const Judge judge_06 = {
    .lab = "06-kdtree-3d-build",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_06_new,
    .job_free = job_06_free,
    .judge = judge,
    .write_alone = judge_06_write_alone,
    .passes_alone = passes_alone,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
