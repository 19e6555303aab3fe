// A 3D kd-tree described for people (see tree3d_report.h).
//
// Read next: tree3d_draw.c.
#include "tree3d_report.h"

#include <stdio.h>

// Trees of up to this many nodes are printed node by node.
enum { MAX_PRINTED_NODES = 63 };

// One line for a node: its plane and its children, or its spheres.
static void print_node(const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    if (node.split_axis != KD_LEAF) {
        printf("  node %3u  split at %c = %g, children %u and %u\n", id, "xyz"[node.split_axis],
               (double)node.split_pos, node.first, node.first + 1);
        return;
    }
    printf("  node %3u  leaf, %u %s:", id, node.n_spheres,
           node.n_spheres == 1 ? "sphere" : "spheres");
    for (u32 i = 0; i < node.n_spheres; i++) {
        printf(" %u", tree->sphere_ids[node.first + i]);
    }
    printf("\n");
}

int tree3d_describe(const KdTree3D *tree, Stats *stats)
{
    TreeFigures3D figures;
    if (tree3d_figures(tree, &figures) != 0) {
        return -1;
    }
    stats_integer(stats, "tree.n_nodes", tree->n_nodes);
    stats_integer(stats, "tree.n_leaves", figures.n_leaves);
    stats_integer(stats, "tree.n_empty_leaves", figures.n_empty);
    stats_integer(stats, "tree.depth", figures.depth);
    stats_integer(stats, "tree.n_sphere_ids", tree->n_sphere_ids);
    stats_integer(stats, "tree.largest_leaf", figures.largest_leaf);
    stats_number(stats, "tree.spheres_per_leaf", (double)tree->n_sphere_ids / figures.n_leaves);
    if (tree->n_nodes <= MAX_PRINTED_NODES) {
        const BBox3D box = tree->bounds;
        printf("The tree in x [%g, %g], y [%g, %g], z [%g, %g]:\n", (double)box.min[0],
               (double)box.max[0], (double)box.min[1], (double)box.max[1], (double)box.min[2],
               (double)box.max[2]);
        for (u32 id = 0; id < tree->n_nodes; id++) {
            print_node(tree, id);
        }
    }
    return 0;
}
