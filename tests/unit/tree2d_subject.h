// A 2D kd-tree to spoil, and the judges of trees, one by one or all together.
//
// For the tests of lab 02's solution, of the judges and of the drawings. Read next:
// test_tree2d_faults.c.
#ifndef UNIT_TREE2D_SUBJECT_H
#define UNIT_TREE2D_SUBJECT_H

#include "job_scene_tree.h"
#include "surroundings.h"
#include "told.h"
#include "tree2d_draw.h"
#include "tree_judge.h"

// ---- The judges ---------------------------------------------------------------------------------

enum {
    LIMITS = 1,
    CELLS = 2,
    OVERLAP = 4,
    LISTS = 8,
    PACKING = 16,
    CHECK = 32,  // tree2d_check(): may ids, offsets and counts be followed?
};

static const struct {
    int bit;
    const char *name;
    Diagnosis (*judge)(const JobScene *, const KdTree2D *);
} judges[] = {{LIMITS, "limits", tree_judge_limits},
              {CELLS, "cells", tree_judge_cells},
              {OVERLAP, "overlap", tree_judge_overlap},
              {LISTS, "lists", tree_judge_lists},
              {PACKING, "packing", tree_judge_packing}};

// Which judges object. Messages are one line each.
static inline int judges_against(const JobScene *scene, const KdTree2D *tree)
{
    int against = 0;
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        char *message = told(judges[i].judge(scene, tree));
        if (message != NULL) {
            against |= judges[i].bit;
            cr_expect(strchr(message, '\n') == NULL &&
                          strstr(message, scene->picture.title) == message,
                      "%s", message);
            free(message);
        }
    }
    capture_begin(2);
    if (tree2d_check(tree, (u32)scene->scene.n_circles) != 0) {
        against |= CHECK;
        expect_one_message(capture_end(2), "tree: ");
    } else {
        cr_expect_str_eq(capture_end(2), "");
    }
    return against;
}

// The same in words.
static inline const char *names_of(int against)
{
    static char names[128];
    names[0] = '\0';
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        if (against & judges[i].bit) {
            strcat(strcat(names, judges[i].name), " ");
        }
    }
    return strcat(names, against & CHECK ? "check" : "");
}

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
    const int against = judges_against(scene, &scene->tree);
    cr_expect_eq(against, 0, "%s, maxDepth %d, targetElementsPerNode %d: %s", scene->picture.title,
                 scene->limits.maxDepth, scene->limits.targetElementsPerNode, names_of(against));
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

// ---- The subject --------------------------------------------------------------------------------

// A copy whose arrays end where they say, so that the sanitizers see a step too far.
static inline void *copy_of(const void *bytes, size_t n_bytes)
{
    void *copy = malloc(n_bytes);
    memcpy(copy, bytes, n_bytes);
    return copy;
}

static inline KdTree2D tree_copy(const KdTree2D *tree)
{
    KdTree2D copy = *tree;
    copy.nodes_Relations = copy_of(tree->nodes_Relations, tree->n_nodes * sizeof(NodeRel));
    copy.nodes_flag = copy_of(tree->nodes_flag, tree->n_nodes);
    copy.nodes_BBox = copy_of(tree->nodes_BBox, tree->n_nodes * sizeof(BBox2D));
    copy.mapNode2Circles = copy_of(tree->mapNode2Circles, tree->n_map * sizeof(u32));
    return copy;
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
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        free(told(judges[i].judge(scene, tree)));
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
