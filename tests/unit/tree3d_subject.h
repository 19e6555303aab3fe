// A 3D kd-tree to spoil, and the judges of trees, one by one or all together.
//
// For the tests of these judges. Read next: test_tree3d_faults.c.
#ifndef UNIT_TREE3D_SUBJECT_H
#define UNIT_TREE3D_SUBJECT_H

#include "kdtree3d_build.h"
#include "surroundings.h"
#include "tree3d_judge.h"

typedef TreeScene3D Scene;
typedef KdTree3D Tree;

enum { BOUNDS = 1, SPLITS = 2, OVERLAP = 4, LISTS = 8, PACKING = 16, DEPTH = 32 };
#define JUDGES                                                                                     \
    {BOUNDS, "bounds", tree3d_judge_bounds}, {SPLITS, "splits", tree3d_judge_splits},              \
        {OVERLAP, "overlap", tree3d_judge_overlap}, {LISTS, "lists", tree3d_judge_lists},          \
        {PACKING, "packing", tree3d_judge_packing},                                                \
    {                                                                                              \
        DEPTH, "depth", tree3d_judge_depth                                                         \
    }

static inline const char *title_of(const Scene *scene)
{
    return scene->title;
}

static inline int check_against(const Scene *scene, const Tree *tree)
{
    (void)scene, (void)tree;
    return 0;
}

// A copy whose arrays end where they say, so that the sanitizers see a step too far.
static inline Tree tree_copy(const Tree *tree)
{
    Tree copy = *tree;
    copy.nodes = malloc(tree->n_nodes * sizeof *copy.nodes);
    copy.sphere_ids = malloc(tree->n_sphere_ids * sizeof *copy.sphere_ids);
    memcpy(copy.nodes, tree->nodes, tree->n_nodes * sizeof *copy.nodes);
    memcpy(copy.sphere_ids, tree->sphere_ids, tree->n_sphere_ids * sizeof *copy.sphere_ids);
    return copy;
}

static inline void tree_free(Tree *tree)
{
    tree3d_free(tree);
}

#include "tree_faults.h"

static inline void grow(TreeScene3D *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    cr_assert_eq(
        kdtree3d_build(scene->scene.spheres, (u32)scene->scene.n_spheres, limits, &scene->tree), 0);
    scene->is_exact = tree3d_judge_is_exact(scene);
}

static inline TreeScene3D scene_of(const char *name, KdTreeLimits limits)
{
    TreeScene3D scene = {0};
    snprintf(scene.title, sizeof scene.title, "%s", name);
    cr_assert_eq(scene3d_open(name, 64, 48, &scene.scene), 0);
    grow(&scene, limits);
    return scene;
}

static inline void scene_close(TreeScene3D *scene)
{
    tree3d_free(&scene->tree);
    scene3d_free(&scene->scene);
}

// The subject: all inner nodes come first, so that what is done to one leaf shifts no other.
enum { N_INNER = 15, N_NODES = 31, A_LEAF = 20 };

static inline TreeScene3D subject_open(void)
{
    TreeScene3D scene = scene_of("random:n=60,seed=4,min=0.25,max=0.375", (KdTreeLimits){5, 1});
    cr_assert_eq(scene.tree.n_nodes, N_NODES);
    for (u32 id = 0; id < N_NODES; id++) {
        cr_assert_eq(scene.tree.nodes[id].split_axis == KD_LEAF, id >= N_INNER);
        cr_assert(id < N_INNER || scene.tree.nodes[id].n_spheres >= 3);
    }
    expect_no_objection(&scene);
    return scene;
}

#endif
