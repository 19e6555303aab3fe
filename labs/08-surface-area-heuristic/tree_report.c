// A tree as lab 08 looks at it (see tree_report.h).
//
// Flow: scene -> BUFFERS -> kernel -> image: figures of the tree, before it is copied to the
// device. Read next: main.c.
#include "tree_report.h"

#include "complain.h"
#include "kdtree3d_sah.h"

#include <stdio.h>
#include <stdlib.h>

double tree_cost(const KdTree3D *tree)
{
    BBox3D *cells = calloc(tree->n_nodes, sizeof *cells);
    if (cells == NULL) {
        complain("tree: no memory for the cells of %u nodes", tree->n_nodes);
        return -1;
    }
    double cost = 0;
    cells[0] = tree->bounds;
    // Children come behind their parents, so a cell is known when its node's turn comes.
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const KdNode3 node = tree->nodes[id];
        const double probability = surface_area(cells[id]) / surface_area(tree->bounds);
        if (node.split_axis == KD_LEAF) {
            cost += probability * KD_COST_TEST * node.n_spheres;
            continue;
        }
        cost += probability * KD_COST_TRAVERSAL;
        cells[node.first] = cells[node.first + 1] = cells[id];
        cells[node.first].max[node.split_axis] = node.split_pos;
        cells[node.first + 1].min[node.split_axis] = node.split_pos;
    }
    free(cells);
    return cost;
}

int tree_report(const KdTree3D *tree, const char *name, double build_ms, Stats *stats)
{
    TreeFigures3D figures;
    const double cost = tree_cost(tree);
    if (cost < 0 || tree3d_figures(tree, &figures) != 0) {
        return -1;
    }
    char figure[64];
    snprintf(figure, sizeof figure, "%s.cost", name);
    stats_number(stats, figure, cost);
    snprintf(figure, sizeof figure, "%s.build_ms", name);
    stats_number(stats, figure, build_ms);
    const struct {
        const char *what;
        int64_t count;
    } counts[] = {
        {"n_nodes", tree->n_nodes},
        {"depth", figures.depth},
        {"largest_leaf", figures.largest_leaf},
        {"n_sphere_ids", tree->n_sphere_ids},
    };
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        snprintf(figure, sizeof figure, "%s.%s", name, counts[i].what);
        stats_integer(stats, figure, counts[i].count);
    }
    return 0;
}
