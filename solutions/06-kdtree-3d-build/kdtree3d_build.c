// Lab 06: building the 3D kd-tree.
//
// Flow: scene -> BUFFERS (this file fills the tree's) -> kernel -> image -> comparison. Called by
// main.c here and in lab 07. Read the contracts in kdtree3d_build.h first, then kdtree3d_build() at
// the end, which shows how the steps go together. is_leaf() is that of lab 02; what is otherwise as
// there is given: the scene's box, the lists of the children, and the building level by level.
#include "kdtree3d_build.h"

#include "array_reserve.h"
#include "kdtree2d_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

BBox3D spheres_bounds(const Sphere *h_spheres, u32 n_spheres)
{
    if (n_spheres == 0) {
        return (BBox3D){{0}, {0}};
    }
    BBox3D box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (u32 i = 0; i < n_spheres; i++) {
        const f32 centre[3] = {h_spheres[i].x, h_spheres[i].y, h_spheres[i].z};
        const f32 radius = fabsf(h_spheres[i].radius);
        for (int axis = 0; axis < 3; axis++) {
            box.min[axis] = fminf(box.min[axis], centre[axis] - radius);
            box.max[axis] = fmaxf(box.max[axis], centre[axis] + radius);
        }
    }
    return box;
}

KdSplit choose_split(BBox3D box)
{
    KdSplit split = {0, 0};
    // TASK choose_split: find the longest side; where two are equal, the axis that comes first.
    //> (void)box;
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 2;
    // END choose_split
    return split;
}

// How far a coordinate lies outside of [min, max], towards either side; 0 inside. In double next to
// nothing is lost to rounding. (Two plain choices: compilers make them without a jump, and this is
// where the building spends its time.)
static double outside(double coordinate, double min, double max)
{
    const double raised = coordinate < min ? min : coordinate;
    const double nearest = raised > max ? max : raised;
    return coordinate - nearest;
}

int sphere_overlaps_box(Sphere sphere, BBox3D box)
{
    // TASK sphere_overlaps_box: outside() on each axis makes the distance from the centre to the
    // cell's nearest point; ask whether the sphere reaches that far.
    //> (void)sphere, (void)box, (void)outside;
    //> return 0;
    const double dx = outside(sphere.x, box.min[0], box.max[0]);
    const double dy = outside(sphere.y, box.min[1], box.max[1]);
    const double dz = outside(sphere.z, box.min[2], box.max[2]);
    return dx * dx + dy * dy + dz * dz <= (double)sphere.radius * sphere.radius;
    // END sphere_overlaps_box
}

u32 distribute_spheres(const Sphere *h_spheres, const u32 *ids, u32 n_ids, BBox3D child,
                       u32 *child_ids)
{
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        // Written in any case and kept only when it overlaps: an `if` here is guessed wrongly by
        // the processor half of the time, which costs more than the test.
        child_ids[n_child_ids] = ids[i];
        n_child_ids += (u32)sphere_overlaps_box(h_spheres[ids[i]], child);
    }
    return n_child_ids;
}

void pack_leaf_range(KdTree3D *tree, u32 id, const u32 *ids, u32 n_ids)
{
    // TASK pack_leaf_range: a leaf is marked by its split_axis; its range starts where the array
    // ends now. There is no count in the array, as in lab 02: it stands in the node.
    //> (void)tree, (void)id, (void)ids, (void)n_ids;
    KdNode3 *node = &tree->nodes[id];
    node->split_axis = KD_LEAF;
    node->first = tree->n_sphere_ids;
    node->n_spheres = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
    // END pack_leaf_range
}

int fits_todo(int level)
{
    // TASK fits_todo: splitting a node makes its children one level deeper. How many nodes can wait
    // at most while a search is at one of them?
    //> (void)level;
    //> return 0;
    return level <= TODO_SIZE;
    // END fits_todo
}

// What a user can do about a tree that grows too large.
#define ADVICE "; choose a smaller --max-depth or a larger --leaf-size"

// An open node: one that still has to become an inner node or a leaf. Its cell is known only here:
// the packed tree has no boxes.
typedef struct OpenNode {
    BBox3D box;
    u32 first_id;  // where its spheres start in the ids of its level
    u32 n_ids;
    int n_failed;  // splits above it that failed
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
    const Sphere *h_spheres;
    KdTreeLimits limits;
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
    const u32 n_child_ids =
        distribute_spheres(builder->h_spheres, ids, n_ids, box, next->ids + next->n_ids);
    if (n_child_ids > n_ids) {
        return "distribute_spheres() returned more spheres than the node has";
    }
    next->open[next->n_open++] = (OpenNode){box, next->n_ids, n_child_ids, 0};
    next->n_ids += n_child_ids;
    return NULL;
}

// Turn node `id`, open on its level, into an inner node with two open children. Returns NULL, or
// what went wrong.
static const char *close_as_inner(Builder *builder, u32 id, OpenNode node, const u32 *ids,
                                  Level *next)
{
    // Each child may get all of them.
    if (level_reserve(next, 2, 2 * node.n_ids) != 0 || add_nodes(builder, 2) != 0) {
        return "no memory" ADVICE;
    }
    const KdSplit split = choose_split(node.box);
    if (split.axis > 2) {
        return "choose_split() returned an axis that is not 0, 1 or 2";
    }
    builder->tree.nodes[id] = (KdNode3){
        .split_pos = split.pos, .split_axis = split.axis, .first = builder->tree.n_nodes - 2};
    BBox3D lower = node.box, higher = node.box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const char *failure = add_child(builder, ids, node.n_ids, lower, next);
    if (failure == NULL) {
        failure = add_child(builder, ids, node.n_ids, higher, next);
    }
    if (failure == NULL) {
        OpenNode *children = next->open + next->n_open - 2;
        children[0].n_failed = children[1].n_failed =
            node.n_failed + split_failed(node.n_ids, children[0].n_ids, children[1].n_ids);
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
    pack_leaf_range(tree, id, ids, n_ids);
    return tree->n_sphere_ids - n_before <= n_ids
               ? NULL
               : "pack_leaf_range() moved n_sphere_ids by more than it was given";
}

// Close every node of a level; their children make the next one. Returns NULL, or what went wrong.
static const char *close_level(Builder *builder, int level_number, const Level *level, Level *next)
{
    // The level's nodes are the last of the tree: ids come out in breadth-first order.
    const u32 first_id = builder->tree.n_nodes - level->n_open;
    const char *failure = NULL;
    next->n_open = next->n_ids = 0;
    for (u32 i = 0; failure == NULL && i < level->n_open; i++) {
        const OpenNode node = level->open[i];
        const u32 *ids = level->ids + node.first_id;
        if (is_leaf(level_number, node.n_ids, node.n_failed, builder->limits)) {
            failure = close_as_leaf(builder, first_id + i, ids, node.n_ids);
        } else if (fits_todo(level_number)) {
            failure = close_as_inner(builder, first_id + i, node, ids, next);
        } else {
            failure = "the tree would be too deep for the todo stack (TODO_SIZE)" ADVICE;
        }
        if (failure != NULL) {
            break;
        }
        if (builder->tree.n_nodes > TREE3D_MAX_NODES) {
            failure = "there would be too many nodes" ADVICE;
        } else if (next->n_ids > TREE3D_MAX_SPHERE_IDS ||
                   builder->tree.n_sphere_ids > TREE3D_MAX_SPHERE_IDS) {
            failure = "the leaves would hold too many spheres" ADVICE;
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
    builder->tree.bounds = spheres_bounds(builder->h_spheres, n_spheres);
    for (u32 i = 0; i < n_spheres; i++) {
        level->ids[i] = i;
    }
    level->n_ids = n_spheres;
    level->open[0] = (OpenNode){builder->tree.bounds, 0, n_spheres, 0};
    level->n_open = 1;
    return NULL;
}

int kdtree3d_build(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree)
{
    Builder builder = {.h_spheres = h_spheres, .limits = limits};
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
        fprintf(stderr, "kdtree3d_build: %s\n", failure);
        tree3d_free(&builder.tree);
        return -1;
    }
    *tree = builder.tree;
    return 0;
}
