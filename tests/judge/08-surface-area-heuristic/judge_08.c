// Judge of lab 08: each function on chosen inputs, and whole trees by what a ray costs in them.
// Read next: judge_08.h.
#include "judge_08.h"
#include "tree3d_draw.h"

// ---- Judging whole trees ------------------------------------------------------------------------

static Verdict judge_tree(const void *pointer, int k, const JudgeCheck *check,
                          const Sections *answers)
{
    const TreeScene3D *scene = &((const Job08 *)pointer)->scenes[k];
    KdTree3D own = {0};
    if (job_part_find(answers, "tree", k, "refused", 0) != NULL) {
        return verdict_of(diagnosis_new("%s, maxDepth %d: kdtree3d_build_sah gave up, expected a "
                                        "tree of %u nodes",
                                        scene->title, scene->limits.maxDepth, scene->tree.n_nodes));
    }
    if (tree3d_judge_answer(k, answers, &own)) {
        return verdict_of(check->tree3d(scene, &own));
    }
    if (own.n_nodes > TREE3D_ANSWER_NODES || own.n_sphere_ids > TREE3D_ANSWER_IDS) {
        return verdict_of(diagnosis_new("%s, maxDepth %d: the tree has %u nodes and %u ids, "
                                        "expected %u and %u",
                                        scene->title, scene->limits.maxDepth, own.n_nodes,
                                        own.n_sphere_ids, scene->tree.n_nodes,
                                        scene->tree.n_sphere_ids));
    }
    return verdict_missing;
}

// ---- The report ---------------------------------------------------------------------------------

// Cuts through two of the trees.
static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    static const int drawn[] = {0, 2};
    const Job08 *job = pointer;
    for (int i = 0; i < 2 && result->n_pictures < RESULT_MAX_PICTURES; i++) {
        const TreeScene3D *scene = &job->scenes[drawn[i]];
        PictureResult *picture = &result->pictures[result->n_pictures++];
        KdTree3D own;
        snprintf(picture->title, sizeof picture->title, "cut through the tree over %s",
                 scene->title);
        tree3d_draw(&scene->scene, &scene->tree, &picture->reference);
        if (tree3d_judge_answer(drawn[i], answers, &own) &&
            verdict_passes(verdict_of(tree3d_judge_packing(scene, &own)))) {
            tree3d_draw(&scene->scene, &own, &picture->own);
        }
    }
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"area-boxes", "Boxes of all shapes", "surface_area", 9, .function = &area_08,
     .range = {0, N_BOXES}},
    {"area-flat", "Boxes without volume, and far from 0", "surface_area", 6, .function = &area_08,
     .range = {N_BOXES, N_FLAT}},

    {"cost-planes", "Planes within a cell", "split_cost", 15, "surface_area", .function = &cost_08,
     .range = {0, N_PLANES}, .alone = costs_alone_08},
    {"cost-edges", "Planes on the border, empty children, flat cells", "split_cost", 10,
     "surface_area", .function = &cost_08, .range = {N_PLANES, N_COST_EDGES},
     .alone = costs_alone_08},

    {"best-plane", "The cheapest of all planes", "find_best_split", 12, "surface_area split_cost",
     .function = &best_08, .range = {0, N_CELLS}, .alone = bests_alone_08},
    {"best-ties", "Of equal costs the first", "find_best_split", 7, "surface_area split_cost",
     .function = &best_08, .range = {N_CELLS, N_TIES}, .alone = bests_alone_08},
    {"best-edges", "Flat cells, no spheres, spheres like points and large ones", "find_best_split",
     8, "surface_area split_cost", .function = &best_08, .range = {N_CELLS + N_TIES, N_CELL_EDGES},
     .alone = bests_alone_08},
    {"tree-splits", "Whole trees: no plane is cheaper", "find_best_split", 8, "*",
     .tree = judge_tree, .tree3d = tree_judge_splits_08, .range = {0, N_TREES},
     .alone = bests_alone_08},
    {"tree-work", "Whole trees: what a ray asks and visits", "find_best_split", 5, "*",
     .tree = judge_tree, .tree3d = tree_judge_work_08, .range = {0, N_TREES},
     .alone = bests_alone_08},

    {"leaf-cost", "The cheaper of the two", "is_leaf_by_cost", 8, .function = &decision_08,
     .range = {0, N_BY_COST}},
    {"leaf-limits", "The limits", "is_leaf_by_cost", 6, .function = &decision_08,
     .range = {N_BY_COST, N_BY_LIMITS}},
    {"tree-leaves", "Whole trees: leaves where they are cheaper", "is_leaf_by_cost", 6, "*",
     .tree = judge_tree, .tree3d = tree_judge_leaves_08, .range = {0, N_TREES},
     .alone = decisions_alone_08},
};

static const JobPart parts[] = {
    PART("areas", "surface_area", Job08, areas),
    PART("costs", "split_cost", Job08, costs),
    PART("bests", "find_best_split", Job08, bests),
    PART("best_spheres", "find_best_split", Job08, best_spheres),
    PART("best_ids", "find_best_split", Job08, best_ids),
    PART("decisions", "is_leaf_by_cost", Job08, decisions),
};

const Judge judge_08 = {
    .lab = "08-surface-area-heuristic",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job08),
    .draw = job_08_draw,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(tree3d_scene_kind, Job08, scenes),
    .add_pictures = add_pictures,
};
