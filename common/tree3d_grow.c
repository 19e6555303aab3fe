// Growing a 3D kd-tree level by level (see tree3d_grow.h).
//
// The steps are those of tree2d_grow.c, but two things differ. The cell goes along with the open
// node, as the tree does not keep it. And a level is done in two passes: its nodes are divided,
// each for itself, so that several threads may share them; then they are closed one after the
// other, so that ids come out in the same order.
#include "tree3d_grow.h"

#include "array_reserve.h"
#include "complain.h"

#include <stdlib.h>
#include <string.h>

// What a user can do about a tree that grows too large.
#define ADVICE "; choose a smaller --max-depth or a larger --leaf-size"

// How many shares threads take a level's nodes in: few enough that taking them costs nothing, and
// enough that all threads end together.
#define N_SHARES 256

// Spheres of larger nodes are not fetched: with a cache line of 64 bytes for each, more than these
// would not stay in a core's cache until they are looked at.
#define MOST_FETCHED 4096

// One level of the tree while it is built: its open nodes in order, and their spheres.
typedef struct Level {
    KdOpenNode *open;  // [n_open]
    u32 *ids;          // the open nodes' lists, with gaps between them
    u32 n_ids;         // in all lists together
    u32 n_open;
    size_t open_capacity;
    size_t id_capacity;
} Level;

static void level_free(Level *level)
{
    free(level->open);
    free(level->ids);
    *level = (Level){0};
}

// Room for n elements in an array whose content is not needed any more. It grows only to what it
// must hold, and never shrinks: each page of new memory is cleared by the system first, which took
// a tenth of a build when every level had arrays of its own.
//   array, capacity   as for array_reserve()
// Returns the array, perhaps moved, or NULL when memory runs out: the old one is then still there.
static void *room_for(void *array, size_t n, size_t *capacity, size_t n_bytes)
{
    if (array != NULL && n <= *capacity) {
        return array;
    }
    void *moved = realloc(array, n * n_bytes + 1);  // it may answer NULL to a size of 0
    if (moved != NULL) {
        *capacity = n;
    }
    return moved;
}

// Empty a level, with room for n_open nodes and n_ids ids. Returns 0, or -1 when memory runs out.
static int level_clear(Level *level, size_t n_open, size_t n_ids)
{
    KdOpenNode *open = room_for(level->open, n_open, &level->open_capacity, sizeof *open);
    level->open = open != NULL ? open : level->open;
    u32 *ids = room_for(level->ids, n_ids, &level->id_capacity, sizeof *ids);
    level->ids = ids != NULL ? ids : level->ids;
    level->n_open = level->n_ids = 0;
    return open != NULL && ids != NULL ? 0 : -1;
}

// What the steps have made of an open node.
typedef struct Division {
    int is_inner;
    KdSplit split;
    u32 *child_ids[2];  // in the next level, with room for all of the node's spheres each
    u32 n_child_ids[2];
} Division;

// The tree while it grows, and the capacity of its arrays.
typedef struct Builder {
    const KdSteps *steps;
    const Sphere *h_spheres;
    KdTree3D tree;
    u32 node_capacity;
    u32 id_capacity;
    Division *divisions;  // of the nodes of a level
    size_t division_capacity;
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

// ---- Dividing nodes -------------------------------------------------------------------------

// Ask for a node's spheres, all at once. They lie far apart in memory, and waiting for one after
// the other is most of what building takes.
static void fetch_spheres(const Sphere *h_spheres, const KdOpenNode *node)
{
    for (u32 i = 0; node->n_ids <= MOST_FETCHED && i < node->n_ids; i++) {
        __builtin_prefetch(&h_spheres[node->ids[i]]);
    }
}

// The cell of a node's lower child, 0, or of its higher one, 1.
static BBox3D child_box(BBox3D box, KdSplit split, int child)
{
    (child == 0 ? box.max : box.min)[split.axis] = split.pos;
    return box;
}

// Let the steps divide a node. Nothing is written but the division and the children's lists: nodes
// may be divided in any order, and several at once.
static void divide_node(const Builder *builder, const KdOpenNode *node, Division *division)
{
    const KdSteps *steps = builder->steps;
    fetch_spheres(builder->h_spheres, node);
    division->is_inner = steps->choose_split(steps->rules, node, &division->split);
    if (!division->is_inner || division->split.axis > 2) {
        return;  // of a wrong axis close_as_inner() tells
    }
    for (int child = 0; child < 2; child++) {
        division->n_child_ids[child] = steps->distribute_spheres(
            builder->h_spheres, node->ids, node->n_ids,
            child_box(node->box, division->split, child), division->child_ids[child]);
    }
}

// Divide every node of a level. Returns NULL, or what went wrong.
static const char *divide_level(Builder *builder, const Level *level, Level *next)
{
    Division *divisions =
        room_for(builder->divisions, level->n_open, &builder->division_capacity, sizeof *divisions);
    if (divisions == NULL) {
        return "no memory" ADVICE;
    }
    builder->divisions = divisions;
    // Each child may get all of its parent's spheres.
    if (level_clear(next, 2 * (size_t)level->n_open, 2 * (size_t)level->n_ids) != 0) {
        return "no memory" ADVICE;
    }
    u32 *place = next->ids;
    for (u32 i = 0; i < level->n_open; i++) {
        const u32 n_ids = level->open[i].n_ids;
        divisions[i] = (Division){.child_ids = {place, place + n_ids}};
        place += 2 * n_ids;
    }
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1 + level->n_open / N_SHARES)
#endif
    for (u32 i = 0; i < level->n_open; i++) {
        divide_node(builder, &level->open[i], &divisions[i]);
    }
    return NULL;
}

// ---- Closing nodes --------------------------------------------------------------------------

// Turn node `id`, open on its level, into an inner node with two open children. Returns NULL, or
// what went wrong.
static const char *close_as_inner(Builder *builder, u32 id, const KdOpenNode *node,
                                  const Division *division, Level *next)
{
    const KdSplit split = division->split;
    const u32 *n_ids = division->n_child_ids;
    if (split.axis > 2) {
        return "the axis of a split is not 0, 1 or 2";
    }
    if (n_ids[0] > node->n_ids || n_ids[1] > node->n_ids) {
        return "distribute_spheres() returned more spheres than the node has";
    }
    if (add_nodes(builder, 2) != 0) {
        return "no memory" ADVICE;
    }
    builder->tree.nodes[id] = (KdNode3){
        .split_pos = split.pos, .split_axis = split.axis, .first = builder->tree.n_nodes - 2};
    const int n_failed = node->n_failed + split_failed(node->n_ids, n_ids[0], n_ids[1]);
    for (int child = 0; child < 2; child++) {
        next->open[next->n_open++] =
            (KdOpenNode){child_box(node->box, split, child), division->child_ids[child],
                         n_ids[child], node->level + 1, n_failed};
        next->n_ids += n_ids[child];
    }
    return NULL;
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
static const char *close_node(Builder *builder, u32 id, const KdOpenNode *node,
                              const Division *division, Level *next)
{
    if (!division->is_inner) {
        return close_as_leaf(builder, id, node->ids, node->n_ids);
    }
    return builder->steps->fits_todo(node->level)
               ? close_as_inner(builder, id, node, division, next)
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

// Close every node of a level, in order; their children make the next one. Returns NULL, or what
// went wrong.
static const char *close_level(Builder *builder, const Level *level, Level *next)
{
    // The level's nodes are the last of the tree: ids come out in breadth-first order.
    const u32 first_id = builder->tree.n_nodes - level->n_open;
    const char *failure = divide_level(builder, level, next);
    for (u32 i = 0; failure == NULL && i < level->n_open; i++) {
        failure = close_node(builder, first_id + i, &level->open[i], &builder->divisions[i], next);
        if (failure == NULL) {
            failure = too_large(&builder->tree, next);
        }
    }
    return failure;
}

// The first level: the root, with every sphere. Returns NULL, or what went wrong.
static const char *open_root(Builder *builder, u32 n_spheres, Level *level)
{
    if (level_clear(level, 1, n_spheres) != 0 || add_nodes(builder, 1) != 0) {
        return "no memory" ADVICE;
    }
    for (u32 i = 0; i < n_spheres; i++) {
        level->ids[i] = i;
    }
    level->open[0] = (KdOpenNode){builder->tree.bounds, level->ids, n_spheres, 1, 0};
    level->n_open = 1;
    level->n_ids = n_spheres;
    return NULL;
}

int tree3d_grow(const KdSteps *steps, const Sphere *h_spheres, u32 n_spheres, BBox3D bounds,
                KdTree3D *tree)
{
    Builder builder = {.steps = steps, .h_spheres = h_spheres, .tree.bounds = bounds};
    Level level = {0}, next = {0};
    const char *failure = open_root(&builder, n_spheres, &level);
    while (failure == NULL && level.n_open > 0) {
        failure = close_level(&builder, &level, &next);
        const Level closed = level;
        level = next;
        next = closed;
    }
    level_free(&level);
    level_free(&next);
    free(builder.divisions);
    if (failure != NULL) {
        complain("%s: %s", steps->name, failure);
        tree3d_free(&builder.tree);
        return -1;
    }
    *tree = builder.tree;
    return 0;
}
