// Kd-trees over circles by several rules (see plane_trees.h). The cells, the lists and the limits
// are those of lab 02's functions; only the choice of the plane is new.
#include "plane_trees.h"

#include "array_reserve.h"
#include "complain.h"
#include "kdtree2d_build.h"
#include "options.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

// On each axis N_PLANES candidate planes cut a cell into parts of the same width, as in lab 08.
enum { N_PLANES = 31 };

typedef struct Growth {
    const Scene2D *scene;
    PlaneRule rule;
    PlaneTree tree;
    u32 leaf_capacity;
} Growth;

// A node whose turn it is.
typedef struct Node {
    BBox2D cell;
    const u32 *ids;  // [n_ids], the circles that overlap the cell
    u32 n_ids;
    int level;
    int n_failed;
} Node;

typedef struct Halves {
    BBox2D left, right;
} Halves;

static void *allocate_ids(u32 n)
{
    void *ids = malloc((n + 1) * sizeof(u32));
    if (ids == NULL) {
        complain("no memory for %u circles", n);
        exit(EXIT_FAILURE);
    }
    return ids;
}

static double width_of(BBox2D box)
{
    return (double)box.maxX - box.minX;
}

static double height_of(BBox2D box)
{
    return (double)box.maxY - box.minY;
}

static double area_of(BBox2D box)
{
    return width_of(box) * height_of(box);
}

static double weigh(PlaneWeight weight, BBox2D box)
{
    return weight == PERIMETER ? 2 * (width_of(box) + height_of(box)) : area_of(box);
}

// ---- The choice of a plane ----------------------------------------------------------------------

static Halves cut_at(BBox2D cell, int axis, int plane)
{
    Halves halves = {cell, cell};
    const float share = (float)plane / (N_PLANES + 1);
    if (axis == 0) {
        halves.left.maxX = halves.right.minX = cell.minX + (cell.maxX - cell.minX) * share;
    } else {
        halves.left.maxY = halves.right.minY = cell.minY + (cell.maxY - cell.minY) * share;
    }
    return halves;
}

static u32 count_in(const Growth *growth, const Node *node, BBox2D child)
{
    u32 n = 0;
    for (u32 i = 0; i < node->n_ids; i++) {
        n += (u32)circle_overlaps_box(growth->scene->circles[node->ids[i]], child);
    }
    return n;
}

double plane_split_cost(PlaneWeight weight, BBox2D cell, BBox2D left, BBox2D right, u32 n_left,
                        u32 n_right)
{
    const double n_expected =
        (weigh(weight, left) * n_left + weigh(weight, right) * n_right) / weigh(weight, cell);
    return PLANE_COST_STEP + PLANE_COST_TEST * n_expected;
}

static double cost_of(const Growth *growth, const Node *node, PlaneWeight weight, Halves halves)
{
    return plane_split_cost(weight, node->cell, halves.left, halves.right,
                            count_in(growth, node, halves.left),
                            count_in(growth, node, halves.right));
}

// The cheapest of all candidate planes. Of equal costs the first counts, x before y.
static Halves cheapest(const Growth *growth, const Node *node)
{
    Halves best = {node->cell, node->cell};
    double lowest = INFINITY;
    for (int axis = 0; axis < 2; axis++) {
        for (int plane = 1; plane <= N_PLANES; plane++) {
            const Halves halves = cut_at(node->cell, axis, plane);
            const double cost = cost_of(growth, node, growth->rule.plane, halves);
            if (cost < lowest) {
                lowest = cost;
                best = halves;
            }
        }
    }
    return best;
}

// A node's turn comes. Returns 1 and its halves when it is split, 0 when it stays a leaf.
static int choose_split(const Growth *growth, const Node *node, Halves *halves)
{
    static const KdTreeLimits limits = {OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};
    if (growth->rule.plane == NO_WEIGHT) {
        split_box(node->cell, &halves->left, &halves->right);
    } else {
        *halves = cheapest(growth, node);
    }
    return growth->rule.stop == NO_WEIGHT
               ? !is_leaf(node->level, node->n_ids, node->n_failed, limits)
               : cost_of(growth, node, growth->rule.stop, *halves) < PLANE_COST_TEST * node->n_ids;
}

// ---- Growing ------------------------------------------------------------------------------------

// With which probability does a query that meets the root's cell meet a node's?
static double share_of(const Growth *growth, const Node *node, PlaneWeight weight)
{
    return weigh(weight, node->cell) / weigh(weight, growth->tree.root);
}

static void add_leaf(Growth *growth, const Node *node)
{
    PlaneTree *tree = &growth->tree;
    BBox2D *leaves =
        array_reserve(tree->leaves, tree->n_leaves, 1, &growth->leaf_capacity, sizeof *leaves);
    if (leaves == NULL) {
        complain("no memory for %u leaves", tree->n_leaves + 1);
        exit(EXIT_FAILURE);
    }
    tree->leaves = leaves;
    tree->leaves[tree->n_leaves++] = node->cell;
    tree->n_references += node->n_ids;
    tree->tests += share_of(growth, node, AREA) * node->n_ids;
    tree->line_sum += share_of(growth, node, PERIMETER) * node->n_ids;
}

static void grow(Growth *growth, const Node *node)
{
    Halves halves;
    if (!choose_split(growth, node, &halves)) {
        add_leaf(growth, node);
        return;
    }
    growth->tree.steps += share_of(growth, node, AREA);
    growth->tree.line_sum += share_of(growth, node, PERIMETER);
    const Circle *circles = growth->scene->circles;
    u32 *left_ids = allocate_ids(node->n_ids), *right_ids = allocate_ids(node->n_ids);
    const u32 n_left = distribute(circles, node->ids, node->n_ids, halves.left, left_ids);
    const u32 n_right = distribute(circles, node->ids, node->n_ids, halves.right, right_ids);
    const int n_failed = node->n_failed + split_failed(node->n_ids, n_left, n_right);
    const Node left = {halves.left, left_ids, n_left, node->level + 1, n_failed};
    const Node right = {halves.right, right_ids, n_right, node->level + 1, n_failed};
    grow(growth, &left);
    grow(growth, &right);
    free(left_ids);
    free(right_ids);
}

PlaneTree plane_tree_grow(const Scene2D *scene, PlaneRule rule)
{
    const u32 n_circles = (u32)scene->n_circles;
    Growth growth = {.scene = scene, .rule = rule};
    growth.tree.root = scene_bounds(scene->circles, n_circles);
    u32 *ids = allocate_ids(n_circles);
    for (u32 i = 0; i < n_circles; i++) {
        ids[i] = i;
    }
    grow(&growth, &(Node){growth.tree.root, ids, n_circles, 1, 0});
    free(ids);
    return growth.tree;
}

void plane_tree_free(PlaneTree *tree)
{
    free(tree->leaves);
    *tree = (PlaneTree){0};
}

// ---- Scenes -------------------------------------------------------------------------------------

enum { WIDTH = 640, HEIGHT = 480, N_CIRCLES = 500 };

int plane_scene_random(Scene2D *scene)
{
    return scene2d_random(N_CIRCLES, 1, 2, 20, WIDTH, HEIGHT, scene);
}

// Pixels from a cluster's centre: of three numbers the sum is near the middle more often than not.
static float offset_draw(Random *random)
{
    return random_grid(random, -14, 14) + random_grid(random, -14, 14) +
           random_grid(random, -14, 14);
}

int plane_scene_clusters(Scene2D *scene)
{
    enum { N_CLUSTERS = 10, MARGIN = 60 };
    if (scene2d_create(N_CIRCLES, WIDTH, HEIGHT, scene) != 0) {
        return -1;
    }
    Random random = {1};
    float x[N_CLUSTERS], y[N_CLUSTERS];
    for (int i = 0; i < N_CLUSTERS; i++) {
        x[i] = random_grid(&random, MARGIN, WIDTH - MARGIN);
        y[i] = random_grid(&random, MARGIN, HEIGHT - MARGIN);
    }
    for (int i = 0; i < N_CIRCLES; i++) {
        Circle *circle = &scene->circles[i];
        circle->x = x[i % N_CLUSTERS] + offset_draw(&random);
        circle->y = y[i % N_CLUSTERS] + offset_draw(&random);
        circle->radius = random_grid(&random, 2, 8);
    }
    return 0;
}

int plane_scene_lecture(Scene2D *scene)
{
    return scene2d_random(SCENE2D_DEFAULT_CIRCLES, 1, 2, 20, SCENE2D_DEFAULT_SIZE,
                          SCENE2D_DEFAULT_SIZE, scene);
}
