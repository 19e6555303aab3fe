// Reading a student's tree (see tree3d_walk.h).
#include "tree3d_walk.h"

#include "complain.h"

#include <stdlib.h>

int is_leaf_node(const KdTree3D *tree, u32 id)
{
    return tree->nodes[id].split_axis == KD_LEAF;
}

int has_children(const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    return node.split_axis < 3 && node.first > id && node.first < tree->n_nodes - 1;
}

const u32 *leaf_ids(const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    return node.first <= tree->n_sphere_ids && node.n_spheres <= tree->n_sphere_ids - node.first
               ? tree->sphere_ids + node.first
               : NULL;
}

Diagnosis bad_range(const TreeScene3D *scene, const KdTree3D *own, u32 id)
{
    return diagnosis_new("%s: leaf %u: first is %u and n_spheres %u, but sphere_ids has %u entries",
                         scene->title, id, own->nodes[id].first, own->nodes[id].n_spheres,
                         own->n_sphere_ids);
}

Diagnosis judge_order(const TreeScene3D *scene, const KdTree3D *own, u32 id)
{
    const u32 *ids = leaf_ids(own, id);
    for (u32 i = 1; i < own->nodes[id].n_spheres; i++) {
        if (ids[i] <= ids[i - 1]) {
            return diagnosis_new("%s: leaf %u lists sphere %u after sphere %u: the ids must ascend",
                                 scene->title, id, ids[i], ids[i - 1]);
        }
    }
    return NOTHING_WRONG;
}

void walk_free(Walk *walk)
{
    free(walk->cells);
    free(walk->levels);
}

Walk walk_down(const KdTree3D *tree)
{
    Walk walk = {calloc((size_t)tree->n_nodes + 1, sizeof *walk.cells),
                 calloc((size_t)tree->n_nodes + 1, sizeof *walk.levels)};
    if (walk.cells == NULL || walk.levels == NULL) {
        complain("grade: no memory for a tree");
        exit(2);
    }
    walk.cells[0] = tree->bounds;
    walk.levels[0] = 1;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const KdNode3 node = tree->nodes[id];
        if (walk.levels[id] == 0 || is_leaf_node(tree, id) || !has_children(tree, id)) {
            continue;
        }
        walk.cells[node.first] = walk.cells[node.first + 1] = walk.cells[id];
        walk.cells[node.first].max[node.split_axis] = node.split_pos;
        walk.cells[node.first + 1].min[node.split_axis] = node.split_pos;
        walk.levels[node.first] = walk.levels[node.first + 1] = walk.levels[id] + 1;
    }
    return walk;
}
