// Growing the tree that lab 06 is expected to build: the steps of tree3d_judge_steps.c, one after
// the other. It shares no code with the labs: nothing is handed down from parent to child, every
// cell asks every sphere, in double precision.
#include "tree3d_judge.h"

#include <stdlib.h>

// The tree while it grows, and what its nodes do not hold.
typedef struct Growth {
    const TreeScene3D *scene;
    KdTree3D tree;
    BBox3D *cells;  // [tree.n_nodes]
    int *levels;    // [tree.n_nodes]
    int *n_failed;  // [tree.n_nodes], splits above that failed
    u32 node_room, id_room;
} Growth;

// Make an array twice as large. Returns 0, or -1 when memory runs out.
static int double_room(void **array, u32 room, size_t n_bytes)
{
    void *larger = realloc(*array, (2 * (size_t)room + 1) * n_bytes);
    if (larger == NULL) {
        return -1;
    }
    *array = larger;
    return 0;
}

// Append a node with its cell. Returns 0, or -1 when memory runs out.
static int node_add(Growth *growth, BBox3D cell, int level, int n_failed)
{
    KdTree3D *tree = &growth->tree;
    if (tree->n_nodes == growth->node_room) {
        void *nodes = tree->nodes, *cells = growth->cells;
        void *levels = growth->levels, *failed = growth->n_failed;
        const int result = double_room(&nodes, growth->node_room, sizeof *tree->nodes) |
                           double_room(&cells, growth->node_room, sizeof *growth->cells) |
                           double_room(&levels, growth->node_room, sizeof *growth->levels) |
                           double_room(&failed, growth->node_room, sizeof *growth->n_failed);
        tree->nodes = nodes, growth->cells = cells;
        growth->levels = levels, growth->n_failed = failed;
        if (result != 0) {
            return -1;
        }
        growth->node_room = 2 * growth->node_room + 1;
    }
    tree->nodes[tree->n_nodes] = (KdNode3){.split_axis = KD_LEAF, .first = tree->n_sphere_ids};
    growth->cells[tree->n_nodes] = cell;
    growth->n_failed[tree->n_nodes] = n_failed;
    growth->levels[tree->n_nodes++] = level;
    return 0;
}

// Room for one id more. Returns 0, or -1 when memory runs out.
static int reserve_id(Growth *growth)
{
    if (growth->tree.n_sphere_ids < growth->id_room) {
        return 0;
    }
    void *ids = growth->tree.sphere_ids;
    const int result = double_room(&ids, growth->id_room, sizeof *growth->tree.sphere_ids);
    growth->tree.sphere_ids = ids;
    growth->id_room = result == 0 ? 2 * growth->id_room + 1 : growth->id_room;
    return result;
}

// Append the spheres of a cell to the lists, those that touch it as nearly as float can tell, too.
// Returns 0, or -1 when memory runs out.
static int list_append(Growth *growth, BBox3D cell, u32 *n_listed)
{
    KdTree3D *tree = &growth->tree;
    const Scene3D *scene = &growth->scene->scene;
    *n_listed = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        if (tree3d_judge_sphere(scene->spheres[i], cell) == SPHERE_OUTSIDE) {
            continue;
        }
        if (reserve_id(growth) != 0) {
            return -1;
        }
        tree->sphere_ids[tree->n_sphere_ids++] = (u32)i;
        ++*n_listed;
    }
    return 0;
}

// How many spheres list_append() would list.
static u32 n_in(const Scene3D *scene, BBox3D cell)
{
    u32 n = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        n += tree3d_judge_sphere(scene->spheres[i], cell) != SPHERE_OUTSIDE;
    }
    return n;
}

// Make node `id` a leaf with its list, or split it. Returns 0, or -1 when memory runs out.
static int node_close(Growth *growth, u32 id)
{
    KdTree3D *tree = &growth->tree;
    const KdTreeLimits limits = growth->scene->limits;
    const BBox3D cell = growth->cells[id];
    const int level = growth->levels[id];
    const u32 first_id = tree->n_sphere_ids;
    u32 n_listed;
    if (list_append(growth, cell, &n_listed) != 0) {
        return -1;
    }
    if (level >= limits.maxDepth || (int64_t)n_listed <= limits.targetElementsPerNode ||
        growth->n_failed[id] >= MAX_FAILED_SPLITS) {
        tree->nodes[id].first = first_id;
        tree->nodes[id].n_spheres = n_listed;
        return 0;
    }
    tree->n_sphere_ids = first_id;
    const u32 axis = tree3d_expected_axis(cell);
    BBox3D halves[2] = {cell, cell};
    halves[0].max[axis] = halves[1].min[axis] = tree3d_expected_middle(cell, axis);
    tree->nodes[id] = (KdNode3){halves[0].max[axis], axis, tree->n_nodes, 0};
    const Scene3D *scene = &growth->scene->scene;
    const int n_failed = growth->n_failed[id] + tree3d_split_fails(n_listed, n_in(scene, halves[0]),
                                                                   n_in(scene, halves[1]));
    return node_add(growth, halves[0], level + 1, n_failed) |
           node_add(growth, halves[1], level + 1, n_failed);
}

int tree3d_expect(TreeScene3D *scene)
{
    const Scene3D *spheres = &scene->scene;
    Growth growth = {.scene = scene};
    growth.tree.bounds = tree3d_expected_box(spheres->spheres, (u32)spheres->n_spheres);
    // Empty lists are lists, too: there is an array even without ids.
    int result = reserve_id(&growth) | node_add(&growth, growth.tree.bounds, 1, 0);
    for (u32 id = 0; result == 0 && id < growth.tree.n_nodes; id++) {
        result = node_close(&growth, id);
    }
    free(growth.cells);
    free(growth.levels);
    free(growth.n_failed);
    if (result != 0) {
        fprintf(stderr, "grade: no memory for a tree\n");
        tree3d_free(&growth.tree);
        return -1;
    }
    scene->tree = growth.tree;
    scene->is_exact = tree3d_judge_is_exact(scene);
    return 0;
}
