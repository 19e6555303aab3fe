// Lab 02: building the 2D kd-tree.
//
// Flow: scene -> BUFFERS (this file fills the tree's four) -> kernel -> image -> comparison. Called
// by main.c here and in lab 03. Read the contracts in kdtree2d_build.h first, then kdtree2d_build()
// at the end, which shows how the steps go together.
#include "kdtree2d_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

BBox2D scene_bounds(const Circle *h_circles, u32 n_circles)
{
    if (n_circles == 0) {
        return (BBox2D){0};
    }
    BBox2D box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (u32 i = 0; i < n_circles; i++) {
        const Circle c = h_circles[i];
        box.minX = fminf(box.minX, c.x - c.radius);
        box.maxX = fmaxf(box.maxX, c.x + c.radius);
        box.minY = fminf(box.minY, c.y - c.radius);
        box.maxY = fmaxf(box.maxY, c.y + c.radius);
    }
    // The last covered pixel of a row is at most floor(maxX), and maxX itself is outside a cell.
    return (BBox2D){floorf(box.minX), floorf(box.maxX) + 1, floorf(box.minY), floorf(box.maxY) + 1};
}

int is_leaf(int level, u32 n_circles, int n_failed, KdTreeLimits limits)
{
    // TASK is_leaf: stop on level maxDepth, at targetElementsPerNode circles or fewer, and after
    // MAX_FAILED_SPLITS failed splits.
    //> (void)level, (void)n_circles, (void)n_failed, (void)limits;
    //> return 1;
    return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
    // END is_leaf
}

void split_box(BBox2D box, BBox2D *left, BBox2D *right)
{
    *left = box;
    *right = box;
    // TASK split_box: both start as the whole cell; move the one border of each that the split
    // moves.
    //> // (your code)
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
    // END split_box
}

int circle_overlaps_box(Circle circle, BBox2D box)
{
    // TASK circle_overlaps_box: find the cell's point nearest to the centre, then ask whether the
    // circle covers it. In double every step is exact for the scenes of this course.
    //> (void)circle, (void)box;
    //> return 0;
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
    // END circle_overlaps_box
}

u32 distribute(const Circle *h_circles, const u32 *ids, u32 n_ids, BBox2D child, u32 *child_ids)
{
    // TASK distribute: ask circle_overlaps_box() for each of the node's circles. A circle that
    // overlaps both children goes to both: this function is called once for each.
    //> (void)h_circles, (void)ids, (void)n_ids, (void)child, (void)child_ids;
    //> return 0;
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
    // END distribute
}

void pack_leaf(KdTree2D *tree, u32 id, const u32 *ids, u32 n_ids)
{
    // TASK pack_leaf: circleMapOffset is the place of the count, as in {..., 2, 90, 90000, ...}.
    //> (void)tree, (void)id, (void)ids, (void)n_ids;
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
    // END pack_leaf
}

// What a user can do about a tree that grows too large.
#define ADVICE "; choose a smaller --max-depth or a larger --leaf-size"

// A node that still holds its circles: waiting, in order of ids, to become an inner node or a leaf.
typedef struct OpenNode {
    u32 *ids;  // [n_ids], ascending; owned
    u32 n_ids;
    int level;
    int n_failed;  // splits above it that failed
} OpenNode;

// The tree while it grows, and the open nodes beside it.
typedef struct Builder {
    KdTree2D tree;
    OpenNode *open;     // [tree.n_nodes]; those before the node at work have given up their ids
    u32 node_capacity;  // of the tree's node arrays and of open
    u32 map_capacity;   // of tree.mapNode2Circles
    u64 n_open_ids;     // ids that all open nodes hold together
} Builder;

// Room for one more node in every array that has one entry a node; doubling keeps growing cheap.
static int reserve_node(Builder *builder)
{
    KdTree2D *tree = &builder->tree;
    if (tree->n_nodes < builder->node_capacity) {
        return 0;
    }
    const u32 capacity = builder->node_capacity ? 2 * builder->node_capacity : 256;
    // Each array that could be moved is kept: the others are still where they were.
    NodeRel *relations = realloc(tree->nodes_Relations, capacity * sizeof *relations);
    if (relations != NULL) {
        tree->nodes_Relations = relations;
    }
    u8 *flags = realloc(tree->nodes_flag, capacity * sizeof *flags);
    if (flags != NULL) {
        tree->nodes_flag = flags;
    }
    BBox2D *boxes = realloc(tree->nodes_BBox, capacity * sizeof *boxes);
    if (boxes != NULL) {
        tree->nodes_BBox = boxes;
    }
    OpenNode *open = realloc(builder->open, capacity * sizeof *open);
    if (open != NULL) {
        builder->open = open;
    }
    if (relations == NULL || flags == NULL || boxes == NULL || open == NULL) {
        return -1;
    }
    builder->node_capacity = capacity;
    return 0;
}

// Room for n more entries in mapNode2Circles.
static int reserve_map(Builder *builder, u32 n)
{
    KdTree2D *tree = &builder->tree;
    if (tree->n_map + n <= builder->map_capacity) {
        return 0;
    }
    const u32 capacity = 2 * builder->map_capacity + n;
    u32 *map = realloc(tree->mapNode2Circles, capacity * sizeof *map);
    if (map == NULL) {
        return -1;
    }
    tree->mapNode2Circles = map;
    builder->map_capacity = capacity;
    return 0;
}

// Append an open node; its id is its position. Takes over `ids`, on failure too. Returns NULL, or
// what went wrong.
static const char *add_node(Builder *builder, BBox2D box, u32 *ids, u32 n_ids, int level)
{
    if (reserve_node(builder) != 0) {
        free(ids);
        return "no memory" ADVICE;
    }
    KdTree2D *tree = &builder->tree;
    const u32 id = tree->n_nodes++;
    tree->nodes_Relations[id] = (NodeRel){.id = id};
    tree->nodes_flag[id] = INNER;
    tree->nodes_BBox[id] = box;
    builder->open[id] = (OpenNode){ids, n_ids, level, 0};
    builder->n_open_ids += n_ids;
    return NULL;
}

// Append the child of an open node that has this cell. Returns NULL, or what went wrong.
static const char *add_child(Builder *builder, const Circle *h_circles, OpenNode parent, BBox2D box)
{
    u32 *ids = malloc((parent.n_ids + 1) * sizeof *ids);
    if (ids == NULL) {
        return "no memory" ADVICE;
    }
    const u32 n_ids = distribute(h_circles, parent.ids, parent.n_ids, box, ids);
    if (n_ids > parent.n_ids) {
        free(ids);
        return "distribute() returned more circles than the node has";
    }
    return add_node(builder, box, ids, n_ids, parent.level + 1);
}

// Turn open node `id` into an inner node with two open children. Returns NULL, or what went wrong.
static const char *close_as_inner(Builder *builder, const Circle *h_circles, u32 id)
{
    KdTree2D *tree = &builder->tree;
    const OpenNode node = builder->open[id];
    const u32 lChild = tree->n_nodes, rChild = lChild + 1;
    BBox2D left, right;
    split_box(tree->nodes_BBox[id], &left, &right);
    tree->nodes_Relations[id].lChild = lChild;
    tree->nodes_Relations[id].rChild = rChild;
    const char *failure = add_child(builder, h_circles, node, left);
    if (failure == NULL) {
        failure = add_child(builder, h_circles, node, right);
    }
    if (failure == NULL) {
        OpenNode *open = builder->open;
        open[lChild].n_failed = open[rChild].n_failed =
            node.n_failed + split_failed(node.n_ids, open[lChild].n_ids, open[rChild].n_ids);
    }
    return failure;
}

// Turn open node `id` into a leaf. Returns NULL, or what went wrong.
static const char *close_as_leaf(Builder *builder, u32 id)
{
    KdTree2D *tree = &builder->tree;
    const OpenNode node = builder->open[id];
    if (reserve_map(builder, node.n_ids + 1) != 0) {
        return "no memory" ADVICE;
    }
    const u32 n_before = tree->n_map;
    pack_leaf(tree, id, node.ids, node.n_ids);
    return tree->n_map - n_before <= node.n_ids + 1
               ? NULL
               : "pack_leaf() moved n_map by more than the leaf's list is long";
}

// Turn open node `id` into an inner node or into a leaf. Returns NULL, or what went wrong.
static const char *close_node(Builder *builder, const Circle *h_circles, u32 id,
                              KdTreeLimits limits)
{
    const OpenNode node = builder->open[id];
    const char *failure = is_leaf(node.level, node.n_ids, node.n_failed, limits)
                              ? close_as_leaf(builder, id)
                              : close_as_inner(builder, h_circles, id);
    builder->n_open_ids -= node.n_ids;
    builder->open[id].ids = NULL;
    free(node.ids);
    return failure;
}

// Append the root, which holds every circle. Returns NULL, or what went wrong.
static const char *add_root(Builder *builder, const Circle *h_circles, u32 n_circles)
{
    u32 *ids = malloc((n_circles + 1) * sizeof *ids);
    if (ids == NULL) {
        return "no memory" ADVICE;
    }
    for (u32 i = 0; i < n_circles; i++) {
        ids[i] = i;
    }
    return add_node(builder, scene_bounds(h_circles, n_circles), ids, n_circles, 1);
}

int kdtree2d_build(const Circle *h_circles, u32 n_circles, KdTreeLimits limits, KdTree2D *tree)
{
    Builder builder = {0};
    const char *failure = add_root(&builder, h_circles, n_circles);
    // Children are appended behind all nodes there are, so ids come out in breadth-first order.
    for (u32 id = 0; failure == NULL && id < builder.tree.n_nodes; id++) {
        failure = close_node(&builder, h_circles, id, limits);
        if (failure != NULL) {
            break;
        }
        if (builder.tree.n_map + builder.n_open_ids > TREE2D_MAX_ENTRIES) {
            failure = "the leaves would hold too many circles" ADVICE;
        } else if (builder.tree.n_nodes > TREE2D_MAX_NODES) {
            failure = "there would be too many nodes" ADVICE;
        }
    }
    for (u32 id = 0; id < builder.tree.n_nodes; id++) {
        free(builder.open[id].ids);
    }
    free(builder.open);
    if (failure != NULL) {
        fprintf(stderr, "kdtree2d_build: %s\n", failure);
        tree2d_free(&builder.tree);
        return -1;
    }
    *tree = builder.tree;
    return 0;
}
