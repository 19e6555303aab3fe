// A 2D kd-tree to spoil, and the judges of trees, one by one or all together.
//
// For the tests of lab 02's solution, of the judges and of the drawings. Read next:
// test_tree2d_faults.c.
#ifndef UNIT_TREE2D_SUBJECT_H
#define UNIT_TREE2D_SUBJECT_H

#include "job_scene_tree.h"
#include "surroundings.h"
#include "tree2d_draw.h"
#include "tree_judge.h"

typedef JobScene Scene;
typedef KdTree2D Tree;

enum {
    LIMITS = 1,
    CELLS = 2,
    OVERLAP = 4,
    LISTS = 8,
    PACKING = 16,
    CHECK = 32,  // tree2d_check(): may ids, offsets and counts be followed?
};
#define JUDGES                                                                                     \
    {LIMITS, "limits", tree_judge_limits}, {CELLS, "cells", tree_judge_cells},                     \
        {OVERLAP, "overlap", tree_judge_overlap}, {LISTS, "lists", tree_judge_lists},              \
    {                                                                                              \
        PACKING, "packing", tree_judge_packing                                                     \
    }

static inline const char *title_of(const Scene *scene)
{
    return scene->picture.title;
}

static inline int check_against(const Scene *scene, const Tree *tree)
{
    capture_begin(2);
    const int result = tree2d_check(tree, (u32)scene->scene.n_circles);
    const char *message = capture_end(2);
    if (result == 0) {
        cr_expect_str_eq(message, "");
        return 0;
    }
    expect_one_message(message, "tree: ");
    return CHECK;
}

// A copy whose arrays end where they say, so that the sanitizers see a step too far.
static inline void *copy_of(const void *bytes, size_t n_bytes)
{
    void *copy = malloc(n_bytes);
    memcpy(copy, bytes, n_bytes);
    return copy;
}

static inline Tree tree_copy(const Tree *tree)
{
    Tree copy = *tree;
    copy.nodes_Relations = copy_of(tree->nodes_Relations, tree->n_nodes * sizeof(NodeRel));
    copy.nodes_flag = copy_of(tree->nodes_flag, tree->n_nodes);
    copy.nodes_BBox = copy_of(tree->nodes_BBox, tree->n_nodes * sizeof(BBox2D));
    copy.mapNode2Circles = copy_of(tree->mapNode2Circles, tree->n_map * sizeof(u32));
    return copy;
}

static inline void tree_free(Tree *tree)
{
    tree2d_free(tree);
}

#include "tree_faults.h"

static inline JobScene scene_of(const char *name, int width, int height, KdTreeLimits limits)
{
    JobScene scene = {0};
    snprintf(scene.picture.title, sizeof scene.picture.title, "scene \"%s\"", name);
    cr_assert_eq(scene2d_generate(name, width, height, &scene.scene), 0);
    cr_assert_eq(job_scene_grow_tree(&scene, limits), 0);
    return scene;
}

static inline void expect_good(const JobScene *scene)
{
    expect_no_objection(scene);
    // A leaf's place in the tree is no secret: as deep as allowed or with few enough circles.
    const KdTree2D *tree = &scene->tree;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const NodeRel node = tree->nodes_Relations[id];
        if (tree->nodes_flag[id] == LEAF) {
            cr_expect(node.lChild == 0 && node.rChild == 0);
        } else {
            cr_expect_eq(tree->nodes_flag[id], INNER);
            cr_expect_eq(node.circleMapOffset, 0);
        }
    }
}

// The subject: 31 nodes, all levels full, leaves 15 to 30; leaf 20 and the last one have several
// circles.
enum { LAST_INNER = 14, A_LEAF = 20, LAST_LEAF = 30 };

static inline JobScene subject_open(void)
{
    JobScene scene = scene_of("random:n=60,seed=4,min=8", 64, 48, (KdTreeLimits){5, 2});
    cr_assert_eq(scene.tree.n_nodes, LAST_LEAF + 1);
    expect_good(&scene);
    return scene;
}

// Judge and write as SVG; what is found does not matter here, the sanitizers' silence does.
static inline void survive(const JobScene *scene, const KdTree2D *tree)
{
    for (size_t i = 0; i < sizeof tree_judges / sizeof *tree_judges; i++) {
        free(told(tree_judges[i].judge(scene, tree)));
    }
    (void)tree2d_check(tree, (u32)scene->scene.n_circles);
    char *svg = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&svg, &n_bytes);
    cr_expect_eq(tree2d_write_svg(file, &scene->scene, tree), 0);
    fclose(file);
    cr_expect(strstr(svg, "nan") == NULL && strstr(svg, "inf") == NULL, "not a number in an SVG");
    cr_expect_str_eq(svg + n_bytes - strlen("</svg>\n"), "</svg>\n");
    free(svg);
}

#endif
