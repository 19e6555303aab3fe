// Growing a 2D kd-tree level by level (see tree2d_grow.h). Read tree2d_grow() at the end first.
#include "tree2d_grow.h"

#include "array_reserve.h"

#include <stdio.h>
#include <stdlib.h>

// What a user can do about a tree that grows too large.
#define ADVICE "; choose a smaller --max-depth or a larger --leaf-size"

static const char *const messages[N_KD_FAULTS] = {
    [KD_NO_MEMORY] = "no memory" ADVICE,
    [KD_TOO_MANY_NODES] = "there would be too many nodes" ADVICE,
    [KD_TOO_MANY_CIRCLES] = "the leaves would hold too many circles" ADVICE,
    [KD_LONG_CHILD] = "distribute() returned more circles than the node has",
    [KD_LONG_LEAF] = "pack_leaf() moved n_map by more than the leaf's list is long",
};

// An open node: one that still has to become an inner node or a leaf. Its cell is in the tree.
typedef struct OpenNode {
    u32 first_id;  // where its circles start in the ids of its level
    u32 n_ids;
    int n_failed;  // splits above it that failed
} OpenNode;

// One level of the tree while it is built: its open nodes in order, and their circles.
typedef struct Level {
    OpenNode *open;  // [n_open]
    u32 *ids;        // [n_ids], ascending in each open node
    u32 n_open, open_capacity;
    u32 n_ids, id_capacity;
} Level;

static void level_free(Level *level)
{
    free(level->open);
    free(level->ids);
    *level = (Level){0};
}

// Room for n_open more open nodes and n_ids more ids. Returns 0, or -1 when memory runs out.
static int level_reserve(Level *level, u32 n_open, u32 n_ids)
{
    OpenNode *open =
        array_reserve(level->open, level->n_open, n_open, &level->open_capacity, sizeof *open);
    level->open = open != NULL ? open : level->open;
    u32 *ids = array_reserve(level->ids, level->n_ids, n_ids, &level->id_capacity, sizeof *ids);
    level->ids = ids != NULL ? ids : level->ids;
    return open != NULL && ids != NULL ? 0 : -1;
}

// The tree while it grows, and the capacity of its arrays.
typedef struct Builder {
    const KdSteps2D *steps;
    const Circle *h_circles;
    KdTreeLimits limits;
    KdTree2D tree;
    u32 relation_capacity, flag_capacity, box_capacity;
    u32 map_capacity;
} Builder;

// Room for n more nodes. Returns 0, or -1 when memory runs out.
static int nodes_reserve(Builder *builder, u32 n)
{
    KdTree2D *tree = &builder->tree;
    NodeRel *relations = array_reserve(tree->nodes_Relations, tree->n_nodes, n,
                                       &builder->relation_capacity, sizeof *relations);
    tree->nodes_Relations = relations != NULL ? relations : tree->nodes_Relations;
    u8 *flags =
        array_reserve(tree->nodes_flag, tree->n_nodes, n, &builder->flag_capacity, sizeof *flags);
    tree->nodes_flag = flags != NULL ? flags : tree->nodes_flag;
    BBox2D *boxes =
        array_reserve(tree->nodes_BBox, tree->n_nodes, n, &builder->box_capacity, sizeof *boxes);
    tree->nodes_BBox = boxes != NULL ? boxes : tree->nodes_BBox;
    return relations != NULL && flags != NULL && boxes != NULL ? 0 : -1;
}

// Append n nodes, still open and without cells. Returns 0, or -1 when memory runs out.
static int add_nodes(Builder *builder, u32 n)
{
    KdTree2D *tree = &builder->tree;
    if (nodes_reserve(builder, n) != 0) {
        return -1;
    }
    for (u32 end = tree->n_nodes + n; tree->n_nodes < end; tree->n_nodes++) {
        tree->nodes_Relations[tree->n_nodes] = (NodeRel){.id = tree->n_nodes};
        tree->nodes_flag[tree->n_nodes] = INNER;
        tree->nodes_BBox[tree->n_nodes] = (BBox2D){0};
    }
    return 0;
}

// Append an open child to the next level, with those of its parent's circles that overlap its cell.
// Returns KD_BUILT, or what went wrong.
static KdFault add_child(const Builder *builder, const u32 *ids, u32 n_ids, BBox2D box, Level *next)
{
    const u32 n_child_ids =
        builder->steps->distribute(builder->h_circles, ids, n_ids, box, next->ids + next->n_ids);
    if (n_child_ids > n_ids) {
        return KD_LONG_CHILD;
    }
    next->open[next->n_open++] = (OpenNode){next->n_ids, n_child_ids, 0};
    next->n_ids += n_child_ids;
    return KD_BUILT;
}

// Turn node `id`, open on its level, into an inner node with two open children. Returns KD_BUILT,
// or what went wrong.
static KdFault close_as_inner(Builder *builder, u32 id, OpenNode node, const u32 *ids, Level *next)
{
    // Each child may get all of them.
    if (level_reserve(next, 2, 2 * node.n_ids) != 0 || add_nodes(builder, 2) != 0) {
        return KD_NO_MEMORY;
    }
    KdTree2D *tree = &builder->tree;
    const u32 lChild = tree->n_nodes - 2, rChild = lChild + 1;
    tree->nodes_Relations[id].lChild = lChild;
    tree->nodes_Relations[id].rChild = rChild;
    builder->steps->split_box(tree->nodes_BBox[id], &tree->nodes_BBox[lChild],
                              &tree->nodes_BBox[rChild]);
    KdFault fault = add_child(builder, ids, node.n_ids, tree->nodes_BBox[lChild], next);
    if (fault == KD_BUILT) {
        fault = add_child(builder, ids, node.n_ids, tree->nodes_BBox[rChild], next);
    }
    if (fault == KD_BUILT) {
        OpenNode *children = next->open + next->n_open - 2;
        children[0].n_failed = children[1].n_failed =
            node.n_failed + split_failed(node.n_ids, children[0].n_ids, children[1].n_ids);
    }
    return fault;
}

// Turn node `id`, open on its level, into a leaf. Returns KD_BUILT, or what went wrong.
static KdFault close_as_leaf(Builder *builder, u32 id, const u32 *ids, u32 n_ids)
{
    KdTree2D *tree = &builder->tree;
    u32 *moved = array_reserve(tree->mapNode2Circles, tree->n_map, n_ids + 1,
                               &builder->map_capacity, sizeof *moved);
    if (moved == NULL) {
        return KD_NO_MEMORY;
    }
    tree->mapNode2Circles = moved;
    const u32 n_before = tree->n_map;
    builder->steps->pack_leaf(tree, id, ids, n_ids);
    return tree->n_map - n_before <= n_ids + 1 ? KD_BUILT : KD_LONG_LEAF;
}

// Close every node of a level; their children make the next one. Returns KD_BUILT, or what went
// wrong.
static KdFault close_level(Builder *builder, int level_number, const Level *level, Level *next)
{
    // The level's nodes are the last of the tree: ids come out in breadth-first order.
    const u32 first_id = builder->tree.n_nodes - level->n_open;
    KdFault fault = KD_BUILT;
    next->n_open = next->n_ids = 0;
    for (u32 i = 0; fault == KD_BUILT && i < level->n_open; i++) {
        const OpenNode node = level->open[i];
        const u32 *ids = level->ids + node.first_id;
        fault = builder->steps->is_leaf(level_number, node.n_ids, node.n_failed, builder->limits)
                    ? close_as_leaf(builder, first_id + i, ids, node.n_ids)
                    : close_as_inner(builder, first_id + i, node, ids, next);
        if (fault != KD_BUILT) {
            break;
        }
        if (next->n_ids > TREE2D_MAX_ENTRIES || builder->tree.n_map > TREE2D_MAX_ENTRIES) {
            fault = KD_TOO_MANY_CIRCLES;
        } else if (builder->tree.n_nodes > TREE2D_MAX_NODES) {
            fault = KD_TOO_MANY_NODES;
        }
    }
    return fault;
}

// The first level: the root, with every circle. Returns KD_BUILT, or what went wrong.
static KdFault open_root(Builder *builder, BBox2D bounds, u32 n_circles, Level *level)
{
    if (level_reserve(level, 1, n_circles) != 0 || add_nodes(builder, 1) != 0) {
        return KD_NO_MEMORY;
    }
    builder->tree.nodes_BBox[0] = bounds;
    for (u32 i = 0; i < n_circles; i++) {
        level->ids[i] = i;
    }
    level->n_ids = n_circles;
    level->open[0] = (OpenNode){0, n_circles, 0};
    level->n_open = 1;
    return KD_BUILT;
}

int tree2d_grow(const KdSteps2D *steps, const Circle *h_circles, u32 n_circles, BBox2D bounds,
                KdTreeLimits limits, KdTree2D *tree)
{
    Builder builder = {.steps = steps, .h_circles = h_circles, .limits = limits};
    Level level = {0}, next = {0};
    KdFault fault = open_root(&builder, bounds, n_circles, &level);
    for (int number = 1; fault == KD_BUILT && level.n_open > 0; number++) {
        fault = close_level(&builder, number, &level, &next);
        const Level closed = level;
        level = next;
        next = closed;
    }
    level_free(&level);
    level_free(&next);
    if (fault != KD_BUILT) {
        fprintf(stderr, "kdtree2d_build: %s\n", messages[fault]);
        tree2d_free(&builder.tree);
        return fault;
    }
    *tree = builder.tree;
    return KD_BUILT;
}
