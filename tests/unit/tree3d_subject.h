// A 3D kd-tree to spoil, and the judges of trees, one by one or all together.
//
// For the tests of these judges. Read next: test_tree3d_faults.c.
#ifndef UNIT_TREE3D_SUBJECT_H
#define UNIT_TREE3D_SUBJECT_H

#include "kdtree3d_build.h"
#include "surroundings.h"
#include "told.h"
#include "tree3d_judge.h"

// ---- The judges ---------------------------------------------------------------------------------

enum { BOUNDS = 1, SPLITS = 2, OVERLAP = 4, LISTS = 8, PACKING = 16, DEPTH = 32 };

static const struct {
    int bit;
    const char *name;
    Diagnosis (*judge)(const TreeScene3D *, const KdTree3D *);
} tree_judges[] = {
    {BOUNDS, "bounds", tree3d_judge_bounds},    {SPLITS, "splits", tree3d_judge_splits},
    {OVERLAP, "overlap", tree3d_judge_overlap}, {LISTS, "lists", tree3d_judge_lists},
    {PACKING, "packing", tree3d_judge_packing}, {DEPTH, "depth", tree3d_judge_depth},
};

// Which judges object. Messages are one line each and begin with the scene.
static inline int judges_against(const TreeScene3D *scene, const KdTree3D *tree)
{
    int against = 0;
    for (size_t i = 0; i < sizeof tree_judges / sizeof *tree_judges; i++) {
        char *message = told(tree_judges[i].judge(scene, tree));
        if (message != NULL) {
            against |= tree_judges[i].bit;
            cr_expect(strchr(message, '\n') == NULL && strstr(message, scene->title) == message,
                      "%s", message);
            free(message);
        }
    }
    return against;
}

// The same in words.
static const char *names_of(int against)
{
    static char names[64];
    names[0] = '\0';
    for (size_t i = 0; i < sizeof tree_judges / sizeof *tree_judges; i++) {
        if (against & tree_judges[i].bit) {
            strcat(strcat(names, tree_judges[i].name), " ");
        }
    }
    return names;
}

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

static inline void expect_good(const TreeScene3D *scene)
{
    const int against = judges_against(scene, &scene->tree);
    cr_expect_eq(against, 0, "%s, maxDepth %d, targetElementsPerNode %d: %s", scene->title,
                 scene->limits.maxDepth, scene->limits.targetElementsPerNode, names_of(against));
}

// The message of a judge about one call must hold `says`; NULL: there must be none.
static inline void expect_says(Diagnosis diagnosis, const char *says)
{
    char *message = told(diagnosis);
    if (says == NULL) {
        cr_expect_null(message, "%s", message);
    } else {
        cr_expect(message != NULL && strstr(message, says) != NULL, "found \"%s\", expected \"%s\"",
                  message ? message : "(nothing)", says);
    }
    free(message);
}

// ---- The subject --------------------------------------------------------------------------------

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
    expect_good(&scene);
    return scene;
}

// A copy whose arrays end where they say, so that the sanitizers see a step too far.
static inline KdTree3D tree_copy(const KdTree3D *tree)
{
    KdTree3D copy = *tree;
    copy.nodes = malloc(tree->n_nodes * sizeof *copy.nodes);
    copy.sphere_ids = malloc(tree->n_sphere_ids * sizeof *copy.sphere_ids);
    memcpy(copy.nodes, tree->nodes, tree->n_nodes * sizeof *copy.nodes);
    memcpy(copy.sphere_ids, tree->sphere_ids, tree->n_sphere_ids * sizeof *copy.sphere_ids);
    return copy;
}

#endif
