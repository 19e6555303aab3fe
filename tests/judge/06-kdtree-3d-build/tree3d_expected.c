// The tree that lab 06 is expected to build: the steps of tree3d_judge_steps.c, grown by
// oracle_tree.h and packed. It shares no code with the labs.
#include "tree3d_judge.h"

#include "complain.h"

#include <stdlib.h>

// The steps, as oracle_tree.h has them. Spheres that touch a cell as nearly as double can tell are
// in its list, too.
static int overlaps(const void *scene, u32 id, BBox3D cell)
{
    return tree3d_judge_sphere(((const Scene3D *)scene)->spheres[id], cell) != SPHERE_OUTSIDE;
}

static u32 halve(BBox3D cell, BBox3D halves[2])
{
    const u32 axis = tree3d_expected_axis(cell);
    halves[0] = halves[1] = cell;
    halves[0].max[axis] = halves[1].min[axis] = tree3d_expected_middle(cell, axis);
    return axis;
}

// Returns 0, or -1 after one message.
static int pack(const Growth *growth, const GrownNode *nodes, u32 n_nodes, KdTree3D *tree)
{
    u32 n_ids = 0;
    for (u32 id = 0; id < n_nodes; id++) {
        n_ids += nodes[id].first_child == 0 ? nodes[id].n_ids : 0;
    }
    *tree = (KdTree3D){.bounds = nodes[0].cell,
                       .nodes = calloc(n_nodes, sizeof *tree->nodes),
                       // Empty lists are lists, too: there is an array even without ids.
                       .sphere_ids = calloc((size_t)n_ids + 1, sizeof *tree->sphere_ids),
                       .n_nodes = n_nodes};
    if (tree->nodes == NULL || tree->sphere_ids == NULL) {
        complain("grade: no memory for a tree");
        tree3d_free(tree);
        return -1;
    }
    for (u32 id = 0; id < n_nodes; id++) {
        const GrownNode *node = &nodes[id];
        if (node->first_child != 0) {
            const f32 plane = grown_child(node, 1)->cell.min[node->split_axis];
            tree->nodes[id] = (KdNode3){plane, node->split_axis, node->first_child, 0};
            continue;
        }
        tree->nodes[id] = (KdNode3){0, KD_LEAF, tree->n_sphere_ids, node->n_ids};
        for (u32 i = 0; i < node->n_ids; i++) {
            tree->sphere_ids[tree->n_sphere_ids++] = growth->ids[node->first_id + i];
        }
    }
    return 0;
}

int tree3d_expect(TreeScene3D *scene, u32 k, Growth *growth)
{
    const Scene3D *s = &scene->scene;
    const GrowthRules rules = {s, (u32)s->n_spheres, overlaps, halve, scene->limits};
    if (growth_add(growth, k, tree3d_expected_box(s->spheres, (u32)s->n_spheres), &rules) != 0) {
        return -1;
    }
    u32 n_nodes;
    const GrownNode *nodes = growth_nodes(growth, k, &n_nodes);
    const int result = pack(growth, nodes, n_nodes, &scene->tree);
    scene->is_exact = result == 0 && tree3d_judge_is_exact(scene);
    return result;
}
