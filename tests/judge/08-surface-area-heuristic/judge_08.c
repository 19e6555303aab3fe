// Judge of lab 08: each function on chosen inputs, and whole trees by what a ray costs in them.
// Read next: judge_08.h.
#include "judge_08.h"

// ---- Judging whole trees ------------------------------------------------------------------------

static Verdict judge_tree(const void *job, int k, const JudgeCheck *check, const Sections *answers)
{
    const TreeScene3D *scene = job_scene(job, k);
    if (tree3d_is_refused(k, answers)) {
        return verdict_of(diagnosis_new("%s, maxDepth %d: kdtree3d_build_sah gave up, expected a "
                                        "tree of %u nodes",
                                        scene->title, scene->limits.maxDepth, scene->tree.n_nodes));
    }
    return tree3d_judge_built(scene, k, check, answers);
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"area-boxes", "Boxes of all shapes", "surface_area", .function = &area_08,
     .range = {0, N_BOXES}},
    {"area-flat", "Boxes without volume, and far from 0", "surface_area", .function = &area_08,
     .range = {N_BOXES, N_FLAT}},

    {"cost-planes", "Planes within a cell", "split_cost", "surface_area", .function = &cost_08,
     .range = {0, N_PLANES}, .alone = costs_alone_08, .alone_cause = judge_function_alone},
    {"cost-edges", "Planes on the border, empty children, flat cells", "split_cost", "surface_area",
     .function = &cost_08, .range = {N_PLANES, N_COST_EDGES}, .alone = costs_alone_08,
     .alone_cause = judge_function_alone},

    {"best-plane", "The cheapest of all planes", "find_best_split", "surface_area split_cost",
     .function = &best_08, .range = {0, N_CELLS}, .alone = bests_alone_08,
     .alone_cause = judge_function_alone},
    {"best-ties", "Of equal costs the first", "find_best_split", "surface_area split_cost",
     .function = &best_08, .range = {N_CELLS, N_TIES}, .alone = bests_alone_08,
     .alone_cause = judge_function_alone},
    {"best-edges", "Flat cells, no spheres, spheres like points and large ones", "find_best_split",
     "surface_area split_cost", .function = &best_08, .range = {N_CELLS + N_TIES, N_CELL_EDGES},
     .alone = bests_alone_08, .alone_cause = judge_function_alone},
    {"tree-splits", "Whole trees: no plane is cheaper", "find_best_split", "*", .tree = judge_tree,
     .tree3d = tree_judge_splits_08, .range = {0, N_TREES}, .alone = bests_alone_08},
    {"tree-work", "Whole trees: what a ray asks and visits", "find_best_split", "*",
     .tree = judge_tree, .tree3d = tree_judge_work_08, .range = {0, N_TREES},
     .alone = bests_alone_08},

    {"leaf-cost", "The cheaper of the two", "is_leaf_by_cost", .function = &decision_08,
     .range = {0, N_BY_COST}},
    {"leaf-limits", "The limits", "is_leaf_by_cost", .function = &decision_08,
     .range = {N_BY_COST, N_BY_LIMITS}},
    {"tree-leaves", "Whole trees: leaves where they are cheaper", "is_leaf_by_cost", "*",
     .tree = judge_tree, .tree3d = tree_judge_leaves_08, .range = {0, N_TREES},
     .alone_functions = {&decision_08}},
};

static const JobPart parts[] = {
    INPUTS("areas", "surface_area", Job08, areas, .describe = tree3d_describe_box),
    INPUTS("costs", "split_cost", Job08, costs),
    INPUTS("bests", "find_best_split", Job08, bests),
    DATA("best_spheres", "find_best_split", Job08, best_spheres),
    DATA("best_ids", "find_best_split", Job08, best_ids),
    INPUTS("decisions", "is_leaf_by_cost", Job08, decisions),
};

const Judge judge_08 = {
    .lab = "08-surface-area-heuristic",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job08),
    .roll = roll_job_08,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(tree3d_scene_kind, Job08, scenes),
    .scene_steps = {{"tree", "while kdtree3d_build_sah built a whole tree", NULL}},
    .add_pictures = tree3d_add_pictures,
};
