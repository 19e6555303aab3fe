// Releasing, checking and measuring the 2D kd-tree's arrays (see tree2d.h).
//
// Between lab 02, whose kdtree2d_build.c fills the arrays, and lab 03, which copies them to the
// device. Read next: tree2d_draw.c.
#include "tree2d.h"

#include "complain.h"

#include <stdio.h>
#include <stdlib.h>

void tree2d_free(KdTree2D *tree)
{
    free(tree->nodes_Relations);
    free(tree->nodes_flag);
    free(tree->nodes_BBox);
    free(tree->mapNode2Circles);
    *tree = (KdTree2D){0};
}

static int check_inner(const KdTree2D *tree, u32 id)
{
    const NodeRel node = tree->nodes_Relations[id];
    if (node.lChild > id && node.rChild > id && node.lChild < tree->n_nodes &&
        node.rChild < tree->n_nodes) {
        return 0;
    }
    if (tree->nodes_flag[id] == INNER && node.lChild == 0 && node.rChild == 0) {
        complain("tree: node %u: marked INNER, but it has no children: was it packed as a leaf "
                 "(pack_leaf)?",
                 id);
        return -1;
    }
    complain("tree: node %u: found children %u and %u, expected ids from %u to %u", id, node.lChild,
             node.rChild, id + 1, tree->n_nodes - 1);
    return -1;
}

static int check_leaf(const KdTree2D *tree, u32 id, u32 n_circles)
{
    const u32 offset = tree->nodes_Relations[id].circleMapOffset;
    if (offset >= tree->n_map) {
        complain("tree: leaf %u: found circleMapOffset %u, expected less than %u", id, offset,
                 tree->n_map);
        return -1;
    }
    const u32 count = tree->mapNode2Circles[offset];
    if (count > tree->n_map - offset - 1) {
        fprintf(
            stderr,
            "tree: leaf %u: found the count %u at circleMapOffset %u, but only %u entries follow\n",
            id, count, offset, tree->n_map - offset - 1);
        return -1;
    }
    for (u32 i = 1; i <= count; i++) {
        const u32 circle = tree->mapNode2Circles[offset + i];
        if (circle >= n_circles) {
            complain("tree: leaf %u: found circle id %u, but the scene has %u", id, circle,
                     n_circles);
            return -1;
        }
    }
    return 0;
}

int tree2d_check(const KdTree2D *tree, u32 n_circles)
{
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const int result =
            tree->nodes_flag[id] == LEAF ? check_leaf(tree, id, n_circles) : check_inner(tree, id);
        if (result != 0) {
            return -1;
        }
    }
    return 0;
}

int tree2d_depth(const KdTree2D *tree)
{
    // calloc() may answer NULL to a size of 0.
    int *levels = calloc(tree->n_nodes + 1, sizeof *levels);
    if (levels == NULL) {
        complain("tree: no memory for the levels of %u nodes", tree->n_nodes);
        return -1;
    }
    int deepest = 0;
    // Children have higher ids than their parents: a node's level is known when its turn comes.
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const int level = ++levels[id];
        deepest = level > deepest ? level : deepest;
        if (tree->nodes_flag[id] != LEAF) {
            levels[tree->nodes_Relations[id].lChild] = level;
            levels[tree->nodes_Relations[id].rChild] = level;
        }
    }
    free(levels);
    return deepest;
}
