// The oracle's 2D kd-tree: its cells, and the packed arrays.
#include "oracle2d_tree.h"

#include "complain.h"
#include "oracle2d.h"

#include <math.h>
#include <stdlib.h>

BBox2D oracle2d_root(const Scene2D *scene)
{
    if (scene->n_circles == 0) {
        return (BBox2D){0};
    }
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle *circle = &scene->circles[i];
        const double centre[2] = {circle->x, circle->y};
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], centre[axis] - (double)circle->radius);
            high[axis] = fmax(high[axis], centre[axis] + (double)circle->radius);
        }
    }
    return (BBox2D){(float)floor(low[0]), (float)(floor(high[0]) + 1), (float)floor(low[1]),
                    (float)(floor(high[1]) + 1)};
}

u32 oracle2d_halves(BBox2D box, BBox2D halves[2])
{
    halves[0] = halves[1] = box;
    if ((double)box.maxX - box.minX >= (double)box.maxY - box.minY) {
        halves[0].maxX = halves[1].minX = (float)(((double)box.minX + box.maxX) / 2);
        return 0;
    }
    halves[0].maxY = halves[1].minY = (float)(((double)box.minY + box.maxY) / 2);
    return 1;
}

u32 oracle2d_n_overlapping(const Scene2D *scene, BBox2D box)
{
    u32 n = 0;
    for (int i = 0; i < scene->n_circles; i++) {
        n += (u32)oracle2d_overlaps_box(scene->circles[i], box);
    }
    return n;
}

BBox2D oracle2d_box(BBox3D cell)
{
    return (BBox2D){cell.min[0], cell.max[0], cell.min[1], cell.max[1]};
}

BBox3D oracle2d_cell(BBox2D box)
{
    return (BBox3D){{box.minX, box.minY, 0}, {box.maxX, box.maxY, 0}};
}

// ---- The steps, as oracle_tree.h has them -------------------------------------------------------

static int overlaps(const void *scene, u32 id, BBox3D cell)
{
    return oracle2d_overlaps_box(((const Scene2D *)scene)->circles[id], oracle2d_box(cell));
}

static u32 halve(BBox3D cell, BBox3D halves[2])
{
    BBox2D boxes[2];
    const u32 axis = oracle2d_halves(oracle2d_box(cell), boxes);
    halves[0] = oracle2d_cell(boxes[0]);
    halves[1] = oracle2d_cell(boxes[1]);
    return axis;
}

// ---- The arrays ---------------------------------------------------------------------------------

// Returns 0, or -1 when memory runs out.
static int pack(const Growth *growth, const GrownNode *nodes, u32 n_nodes, KdTree2D *tree)
{
    u32 n_map = 0;
    for (u32 id = 0; id < n_nodes; id++) {
        n_map += nodes[id].first_child == 0 ? 1 + nodes[id].n_ids : 0;
    }
    *tree = (KdTree2D){
        .nodes_Relations = calloc(n_nodes, sizeof *tree->nodes_Relations),
        .nodes_flag = calloc(n_nodes, sizeof *tree->nodes_flag),
        .nodes_BBox = calloc(n_nodes, sizeof *tree->nodes_BBox),
        .mapNode2Circles = calloc(n_map, sizeof *tree->mapNode2Circles),
        .n_nodes = n_nodes,
    };
    if (tree->nodes_Relations == NULL || tree->nodes_flag == NULL || tree->nodes_BBox == NULL ||
        tree->mapNode2Circles == NULL) {
        return -1;
    }
    for (u32 id = 0; id < n_nodes; id++) {
        const GrownNode *node = &nodes[id];
        const u32 child = node->first_child;
        tree->nodes_BBox[id] = oracle2d_box(node->cell);
        tree->nodes_flag[id] = child == 0 ? LEAF : INNER;
        tree->nodes_Relations[id] = child == 0
                                        ? (NodeRel){.id = id, .circleMapOffset = tree->n_map}
                                        : (NodeRel){.id = id, .lChild = child, .rChild = child + 1};
        if (child == 0) {
            u32 *list = tree->mapNode2Circles + tree->n_map;
            list[0] = node->n_ids;
            for (u32 i = 0; i < node->n_ids; i++) {
                list[1 + i] = growth->ids[node->first_id + i];
            }
            tree->n_map += 1 + node->n_ids;
        }
    }
    return 0;
}

int oracle2d_tree(const Scene2D *scene, u32 k, KdTreeLimits limits, Growth *growth, KdTree2D *tree)
{
    const GrowthRules rules = {scene, (u32)scene->n_circles, overlaps, halve, limits};
    *tree = (KdTree2D){0};
    if (growth_add(growth, k, oracle2d_cell(oracle2d_root(scene)), &rules) != 0) {
        return -1;
    }
    u32 n_nodes;
    const GrownNode *nodes = growth_nodes(growth, k, &n_nodes);
    if (pack(growth, nodes, n_nodes, tree) != 0) {
        complain("grade: no memory for a tree");
        tree2d_free(tree);
        return -1;
    }
    return 0;
}
