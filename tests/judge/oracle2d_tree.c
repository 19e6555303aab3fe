// Growing the oracle's 2D kd-tree: first the cells, level by level, then the packed arrays.
#include "oracle2d_tree.h"

#include "oracle2d.h"

#include <math.h>
#include <stdio.h>
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

void oracle2d_halves(BBox2D box, BBox2D halves[2])
{
    halves[0] = halves[1] = box;
    if ((double)box.maxX - box.minX >= (double)box.maxY - box.minY) {
        halves[0].maxX = halves[1].minX = (float)(((double)box.minX + box.maxX) / 2);
    } else {
        halves[0].maxY = halves[1].minY = (float)(((double)box.minY + box.maxY) / 2);
    }
}

u32 oracle2d_n_overlapping(const Scene2D *scene, BBox2D box)
{
    u32 n = 0;
    for (int i = 0; i < scene->n_circles; i++) {
        n += (u32)oracle2d_overlaps_box(scene->circles[i], box);
    }
    return n;
}

int oracle2d_is_leaf(int level, u32 n_circles, int n_failed, KdTreeLimits limits)
{
    const int may_split = level < limits.maxDepth && n_failed < MAX_FAILED_SPLITS;
    return !may_split || (int64_t)n_circles <= limits.targetElementsPerNode;
}

int oracle2d_split_fails(u32 n_circles, u32 n_lower, u32 n_higher)
{
    // The same by what is lost: of twice the circles at most a tenth.
    const int64_t n_lost = 2 * (int64_t)n_circles - n_lower - n_higher;
    return 10 * n_lost <= 2 * (int64_t)n_circles;
}

// ---- The cells --------------------------------------------------------------------------------

typedef struct Cell {
    BBox2D box;
    int level;
    u32 n_circles;
    int n_failed;     // splits above it that failed
    u32 first_child;  // the other is behind it; 0 for a leaf
} Cell;

// In breadth-first order: a cell's id is its position.
typedef struct Cells {
    Cell *all;  // [n]
    u32 n, room;
} Cells;

// Append a cell, as a leaf. Returns 0, or -1 when memory runs out.
static int cell_add(Cells *cells, const Scene2D *scene, BBox2D box, int level, int n_failed)
{
    if (cells->n == cells->room) {
        const u32 room = 2 * cells->room + 1;
        Cell *larger = realloc(cells->all, room * sizeof *larger);
        if (larger == NULL) {
            return -1;
        }
        cells->all = larger;
        cells->room = room;
    }
    cells->all[cells->n++] = (Cell){box, level, oracle2d_n_overlapping(scene, box), n_failed, 0};
    return 0;
}

// Split whatever the limits let be split. Returns 0, or -1 when memory runs out.
static int cells_grow(Cells *cells, const Scene2D *scene, KdTreeLimits limits)
{
    int result = cell_add(cells, scene, oracle2d_root(scene), 1, 0);
    for (u32 i = 0; result == 0 && i < cells->n; i++) {
        const Cell cell = cells->all[i];
        if (oracle2d_is_leaf(cell.level, cell.n_circles, cell.n_failed, limits)) {
            continue;
        }
        BBox2D halves[2];
        oracle2d_halves(cell.box, halves);
        const int n_failed =
            cell.n_failed + oracle2d_split_fails(cell.n_circles,
                                                 oracle2d_n_overlapping(scene, halves[0]),
                                                 oracle2d_n_overlapping(scene, halves[1]));
        cells->all[i].first_child = cells->n;
        result = cell_add(cells, scene, halves[0], cell.level + 1, n_failed) |
                 cell_add(cells, scene, halves[1], cell.level + 1, n_failed);
    }
    return result;
}

// ---- The arrays -------------------------------------------------------------------------------

static u32 map_entries(const Cells *cells)
{
    u32 n_entries = 0;
    for (u32 i = 0; i < cells->n; i++) {
        n_entries += cells->all[i].first_child == 0 ? 1 + cells->all[i].n_circles : 0;
    }
    return n_entries;
}

// A leaf's list at the end of the map: the count, then who overlaps the cell.
static void list_append(KdTree2D *tree, const Scene2D *scene, const Cell *leaf)
{
    tree->mapNode2Circles[tree->n_map++] = leaf->n_circles;
    for (int circle = 0; circle < scene->n_circles; circle++) {
        if (oracle2d_overlaps_box(scene->circles[circle], leaf->box)) {
            tree->mapNode2Circles[tree->n_map++] = (u32)circle;
        }
    }
}

// Returns 0, or -1 when memory runs out.
static int cells_pack(const Cells *cells, const Scene2D *scene, KdTree2D *tree)
{
    *tree = (KdTree2D){
        .nodes_Relations = calloc(cells->n, sizeof *tree->nodes_Relations),
        .nodes_flag = calloc(cells->n, sizeof *tree->nodes_flag),
        .nodes_BBox = calloc(cells->n, sizeof *tree->nodes_BBox),
        .mapNode2Circles = calloc(map_entries(cells), sizeof *tree->mapNode2Circles),
        .n_nodes = cells->n,
    };
    if (tree->nodes_Relations == NULL || tree->nodes_flag == NULL || tree->nodes_BBox == NULL ||
        tree->mapNode2Circles == NULL) {
        return -1;
    }
    for (u32 i = 0; i < cells->n; i++) {
        const Cell *cell = &cells->all[i];
        const u32 child = cell->first_child;
        tree->nodes_BBox[i] = cell->box;
        tree->nodes_flag[i] = child == 0 ? LEAF : INNER;
        tree->nodes_Relations[i] = child == 0
                                       ? (NodeRel){.id = i, .circleMapOffset = tree->n_map}
                                       : (NodeRel){.id = i, .lChild = child, .rChild = child + 1};
        if (child == 0) {
            list_append(tree, scene, cell);
        }
    }
    return 0;
}

int oracle2d_tree(const Scene2D *scene, KdTreeLimits limits, KdTree2D *tree)
{
    Cells cells = {0};
    *tree = (KdTree2D){0};
    const int result =
        cells_grow(&cells, scene, limits) != 0 || cells_pack(&cells, scene, tree) != 0 ? -1 : 0;
    if (result != 0) {
        fprintf(stderr, "grade: no memory for a tree\n");
        tree2d_free(tree);
    }
    free(cells.all);
    return result;
}
