// Judge of lab 06: each function on chosen inputs, and whole trees by their invariants. Read next:
// judge_06.h.
#include "judge_06.h"

// ---- Judging whole trees ----------------------------------------------------------------------

// Is the root neither a leaf nor has children? Who walks down such a tree
// meets no leaf and comes no level deeper: nothing is wrong there, but nothing is right.
static Diagnosis judge_root(const TreeScene3D *scene, const KdTree3D *own)
{
    const KdNode3 root = own->nodes[0];
    const int has_children = root.split_axis < KD_LEAF && root.first > 0 && own->n_nodes > 2 &&
                             root.first <= own->n_nodes - 2;
    if (root.split_axis == KD_LEAF || has_children) {
        return NOTHING_WRONG;
    }
    return diagnosis_new(
        "%s: node 0, the root: split_axis is %u and first %u of %u nodes, expected "
        "KD_LEAF (%d), or an axis and its children: no search comes to a leaf",
        scene->title, root.split_axis, root.first, own->n_nodes, KD_LEAF);
}

// The scene's box and the lists are given; but a tree is no good without them.
static Diagnosis judge_splits(const TreeScene3D *scene, const KdTree3D *own)
{
    const Diagnosis wrong = tree3d_judge_bounds(scene, own);
    return wrong.found != NULL ? wrong : tree3d_judge_splits(scene, own);
}

static Diagnosis judge_overlap(const TreeScene3D *scene, const KdTree3D *own)
{
    Diagnosis wrong = judge_root(scene, own);
    wrong = wrong.found != NULL ? wrong : tree3d_judge_overlap(scene, own);
    return wrong.found != NULL ? wrong : tree3d_judge_lists(scene, own);
}

// Whoever packs the lists may also put a sphere in the place of another.
static Diagnosis judge_packing(const TreeScene3D *scene, const KdTree3D *own)
{
    const Diagnosis wrong = tree3d_judge_packing(scene, own);
    return wrong.found != NULL ? wrong : tree3d_judge_overlap(scene, own);
}

static Diagnosis judge_depth(const TreeScene3D *scene, const KdTree3D *own)
{
    const Diagnosis wrong = judge_root(scene, own);
    return wrong.found != NULL ? wrong : tree3d_judge_depth(scene, own);
}

static Verdict judge_tree(const void *job, int k, const JudgeCheck *check, const Sections *answers)
{
    const TreeScene3D *scene = job_scene(job, k);
    if (!tree3d_is_refused(k, answers)) {
        return tree3d_judge_built(scene, k, check, answers);
    }
    if (check->tree3d == judge_depth ? k == TOO_DEEP : k == JUST_FITS) {
        return verdict_passed;  // as it must be, or for fits_todo() to answer for
    }
    return verdict_of(diagnosis_new("%s, maxDepth %d: kdtree3d_build gave up, expected a tree of "
                                    "%u nodes: does splitting ever end, does fits_todo() allow it, "
                                    "and do as many ids get into sphere_ids as leaves list?",
                                    scene->title, scene->limits.maxDepth, scene->tree.n_nodes));
}

// ---- The judge ----------------------------------------------------------------------------------

static const JudgeCheck checks[] = {
    {"split-axis", "The longest side, the first where equal", "choose_split",
     .function = &split_axis_06, .range = {0, N_SPLITS}},
    {"split-middle", "In the middle", "choose_split", .function = &split_middle_06,
     .range = {0, N_SPLITS}},
    {"tree-splits", "Whole trees: each plane halves its cell", "choose_split", "*",
     .tree = judge_tree, .tree3d = judge_splits, .range = {0, JUST_FITS + 1},
     .replay = &replay_split_06},

    {"overlap-inside", "Spheres clearly in and clearly out", "sphere_overlaps_box",
     .function = &overlap_06, .range = {0, N_INSIDE}},
    {"overlap-touching", "Touching counts", "sphere_overlaps_box", .function = &overlap_06,
     .range = {N_INSIDE, N_TOUCHING}},
    {"overlap-corner", "Exact at edges and corners", "sphere_overlaps_box", .function = &overlap_06,
     .range = {N_INSIDE + N_TOUCHING, N_CORNER}},
    {"tree-overlap", "Whole trees: each leaf has its spheres", "sphere_overlaps_box", "*",
     .tree = judge_tree, .tree3d = judge_overlap, .range = {0, JUST_FITS + 1},
     .replay = &replay_overlap_06},

    {"pack-node", "The node says where its spheres are", "pack_leaf_range",
     .function = &pack_node_06, .range = {0, N_PACKS}},
    {"pack-ids", "The ids, one behind the other", "pack_leaf_range", .function = &pack_ids_06,
     .range = {0, N_PACKS}},
    {"tree-packing", "Whole trees: packed without gaps", "pack_leaf_range", "*", .tree = judge_tree,
     .tree3d = judge_packing, .range = {0, JUST_FITS + 1}, .alone_scene = packs_alone_06},

    {"fits-levels", "Level by level", "fits_todo", .function = &fits_06, .range = {0, N_LEVELS}},
    {"tree-depth", "Whole trees: too deep ones are refused, others built", "fits_todo", "*",
     .tree = judge_tree, .tree3d = judge_depth, .range = {JUST_FITS, 2}, .alone = levels_alone_06},
};

static void describe_sphere_and_box(const void *input, char *words, size_t n_bytes)
{
    const SphereBoxJob *in = input;
    char box[100];
    tree3d_describe_box(&in->box, box, sizeof box);
    snprintf(words, n_bytes, "sphere at (%g, %g, %g) radius %g, %s", (double)in->sphere.x,
             (double)in->sphere.y, (double)in->sphere.z, (double)in->sphere.radius, box);
}

static void describe_pack(const void *input, char *words, size_t n_bytes)
{
    const PackJob *in = input;
    snprintf(words, n_bytes, "leaf with %u spheres, %u ids before it", in->n_ids, in->n_before);
}

static void describe_level(const void *input, char *words, size_t n_bytes)
{
    snprintf(words, n_bytes, "level %d", (int)*(const LevelJob *)input);
}

static const JobPart parts[] = {
    INPUTS("splits", "choose_split", Job06, splits, .describe = tree3d_describe_box),
    INPUTS("overlaps", "sphere_overlaps_box", Job06, overlaps, .describe = describe_sphere_and_box),
    INPUTS("pack", "pack_leaf_range", Job06, packs, .describe = describe_pack),
    INPUTS("todo", "fits_todo", Job06, levels, .describe = describe_level),
};

const Judge judge_06 = {
    .lab = "06-kdtree-3d-build",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job06),
    .roll = roll_job_06,
    .release = job_06_release,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(tree3d_scene_kind, Job06, scenes),
    .scene_steps = {{"tree", "while kdtree3d_build built a whole tree", NULL}},
    .write_alone = write_alone_06,
    .add_pictures = tree3d_add_pictures,
};
