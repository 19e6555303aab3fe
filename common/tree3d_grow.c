// Growing a 3D kd-tree level by level (see tree3d_grow.h).
//
// Flow: scene -> BUFFERS -> kernel -> image -> comparison. As in lab 02, function by function; only
// the cell goes along with the open node here, as the tree does not keep it.
#include "tree3d_grow.h"

#include "array_reserve.h"
#include "complain.h"

#include <stdlib.h>
#include <string.h>

// What a user can do about a tree that grows too large.
#define ADVICE "; choose a smaller --max-depth or a larger --leaf-size"

// An open node in its level.
typedef struct OpenNode {
    BBox3D box;
    u32 first_id;  // where its spheres start in the ids of its level
    u32 n_ids;
    int n_failed;
} OpenNode;

// One level of the tree while it is built: its open nodes in order, and their spheres.
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
    const KdSteps *steps;
    const Sphere *h_spheres;
    KdTree3D tree;
    u32 node_capacity;
    u32 id_capacity;
} Builder;

// Append n nodes, still open. Returns 0, or -1 when memory runs out.
static int add_nodes(Builder *builder, u32 n)
{
    KdTree3D *tree = &builder->tree;
    KdNode3 *nodes =
        array_reserve(tree->nodes, tree->n_nodes, n, &builder->node_capacity, sizeof *nodes);
    if (nodes == NULL) {
        return -1;
    }
    tree->nodes = nodes;
    memset(nodes + tree->n_nodes, 0, n * sizeof *nodes);
    tree->n_nodes += n;
    return 0;
}

// Append an open child to the next level, with those of its parent's spheres that overlap its cell.
// Returns NULL, or what went wrong.
static const char *add_child(const Builder *builder, const u32 *ids, u32 n_ids, BBox3D box,
                             Level *next)
{
    const u32 n_child_ids = builder->steps->distribute_spheres(builder->h_spheres, ids, n_ids, box,
                                                               next->ids + next->n_ids);
    if (n_child_ids > n_ids) {
        return "distribute_spheres() returned more spheres than the node has";
    }
    next->open[next->n_open++] = (OpenNode){box, next->n_ids, n_child_ids, 0};
    next->n_ids += n_child_ids;
    return NULL;
}

// Turn node `id`, open on its level, into an inner node with two open children. Returns NULL, or
// what went wrong.
static const char *close_as_inner(Builder *builder, u32 id, const KdOpenNode *node, KdSplit split,
                                  Level *next)
{
    if (split.axis > 2) {
        return "the axis of a split is not 0, 1 or 2";
    }
    // Each child may get all of them.
    if (level_reserve(next, 2, 2 * node->n_ids) != 0 || add_nodes(builder, 2) != 0) {
        return "no memory" ADVICE;
    }
    builder->tree.nodes[id] = (KdNode3){
        .split_pos = split.pos, .split_axis = split.axis, .first = builder->tree.n_nodes - 2};
    BBox3D lower = node->box, higher = node->box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const char *failure = add_child(builder, node->ids, node->n_ids, lower, next);
    if (failure == NULL) {
        failure = add_child(builder, node->ids, node->n_ids, higher, next);
    }
    if (failure == NULL) {
        OpenNode *children = next->open + next->n_open - 2;
        children[0].n_failed = children[1].n_failed =
            node->n_failed + split_failed(node->n_ids, children[0].n_ids, children[1].n_ids);
    }
    return failure;
}

// Turn node `id`, open on its level, into a leaf. Returns NULL, or what went wrong.
static const char *close_as_leaf(Builder *builder, u32 id, const u32 *ids, u32 n_ids)
{
    KdTree3D *tree = &builder->tree;
    u32 *moved = array_reserve(tree->sphere_ids, tree->n_sphere_ids, n_ids, &builder->id_capacity,
                               sizeof *moved);
    if (moved == NULL) {
        return "no memory" ADVICE;
    }
    tree->sphere_ids = moved;
    const u32 n_before = tree->n_sphere_ids;
    builder->steps->pack_leaf_range(tree, id, ids, n_ids);
    return tree->n_sphere_ids - n_before <= n_ids
               ? NULL
               : "pack_leaf_range() moved n_sphere_ids by more than it was given";
}

// Turn node `id` into a leaf or an inner node. Returns NULL, or what went wrong.
static const char *close_node(Builder *builder, u32 id, const KdOpenNode *node, Level *next)
{
    const KdSteps *steps = builder->steps;
    KdSplit split = {0};
    if (!steps->choose_split(steps->rules, node, &split)) {
        return close_as_leaf(builder, id, node->ids, node->n_ids);
    }
    return steps->fits_todo(node->level)
               ? close_as_inner(builder, id, node, split, next)
               : "the tree would be too deep for the todo stack (TODO_SIZE)" ADVICE;
}

// Has the tree, with the level that comes next, grown too large? Returns NULL, or how.
static const char *too_large(const KdTree3D *tree, const Level *next)
{
    return tree->n_nodes > TREE3D_MAX_NODES ? "there would be too many nodes" ADVICE
           : next->n_ids > TREE3D_MAX_SPHERE_IDS || tree->n_sphere_ids > TREE3D_MAX_SPHERE_IDS
               ? "the leaves would hold too many spheres" ADVICE
               : NULL;
}

// Close every node of a level; their children make the next one. Returns NULL, or what went wrong.
static const char *close_level(Builder *builder, int level_number, const Level *level, Level *next)
{
    // The level's nodes are the last of the tree: ids come out in breadth-first order.
    const u32 first_id = builder->tree.n_nodes - level->n_open;
    const char *failure = NULL;
    next->n_open = next->n_ids = 0;
    for (u32 i = 0; failure == NULL && i < level->n_open; i++) {
        const OpenNode open = level->open[i];
        const KdOpenNode node = {open.box, level->ids + open.first_id, open.n_ids, level_number,
                                 open.n_failed};
        failure = close_node(builder, first_id + i, &node, next);
        if (failure == NULL) {
            failure = too_large(&builder->tree, next);
        }
    }
    return failure;
}

// The first level: the root, with every sphere. Returns NULL, or what went wrong.
static const char *open_root(Builder *builder, u32 n_spheres, Level *level)
{
    if (level_reserve(level, 1, n_spheres) != 0 || add_nodes(builder, 1) != 0) {
        return "no memory" ADVICE;
    }
    for (u32 i = 0; i < n_spheres; i++) {
        level->ids[i] = i;
    }
    level->n_ids = n_spheres;
    level->open[0] = (OpenNode){builder->tree.bounds, 0, n_spheres, 0};
    level->n_open = 1;
    return NULL;
}

int tree3d_grow(const KdSteps *steps, const Sphere *h_spheres, u32 n_spheres, BBox3D bounds,
                KdTree3D *tree)
{
    Builder builder = {.steps = steps, .h_spheres = h_spheres, .tree.bounds = bounds};
    Level level = {0}, next = {0};
    const char *failure = open_root(&builder, n_spheres, &level);
    for (int number = 1; failure == NULL && level.n_open > 0; number++) {
        failure = close_level(&builder, number, &level, &next);
        const Level closed = level;
        level = next;
        next = closed;
    }
    level_free(&level);
    level_free(&next);
    if (failure != NULL) {
        complain("%s: %s", steps->name, failure);
        tree3d_free(&builder.tree);
        return -1;
    }
    *tree = builder.tree;
    return 0;
}
