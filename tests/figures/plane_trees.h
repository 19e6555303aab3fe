// Lab 08's question in two dimensions: kd-trees over the same circles, cut in the middle as in lab
// 02, or where the cost is lowest, and what a pixel is expected to do in each.
//
// Read next: draw_weights.c, which draws three of them.
#ifndef TESTS_PLANE_TREES_H
#define TESTS_PLANE_TREES_H

#include "kdtree2d.h"
#include "scene2d.h"

// What a cell weighs when a split's cost is reckoned; or nothing is reckoned at all.
typedef enum PlaneWeight { NO_WEIGHT, AREA, PERIMETER } PlaneWeight;

// How a tree is grown: where a cell is cut, and when it is not cut any more.
typedef struct PlaneRule {
    PlaneWeight plane;  // the cheapest of all candidate planes; NO_WEIGHT: the longer side's middle
    PlaneWeight stop;   // when the split costs no less than a leaf; NO_WEIGHT: lab 02's limits
} PlaneRule;

// A step down the tree and a question to a circle count as one each: the cost is then what is
// counted, and no constant can favour a rule.
#define PLANE_COST_STEP 1.0
#define PLANE_COST_TEST 1.0

typedef struct PlaneTree {
    BBox2D root;
    BBox2D *leaves;  // [n_leaves]
    u32 n_leaves;
    u32 n_references;  // circles in all leaves together
    // What a point of the root's cell is expected to take, where all points are as likely. Exact,
    // but for the last places of double: each node counts by its share of the root's area.
    double steps, tests;
    // Steps and tests of a straight line that meets the root's cell, where all such lines are as
    // likely: each node counts by its share of the root's perimeter.
    double line_sum;
} PlaneTree;

// Grow a tree. Release with plane_tree_free(). Running out of memory ends the program with a
// message.
PlaneTree plane_tree_grow(const Scene2D *scene, PlaneRule rule);
void plane_tree_free(PlaneTree *tree);

// What a split costs a query that meets the cell: a step, and the circles of either child by the
// child's weight over the cell's.
//   weight            AREA or PERIMETER
//   n_left, n_right   how many circles each child would have
double plane_split_cost(PlaneWeight weight, BBox2D cell, BBox2D left, BBox2D right, u32 n_left,
                        u32 n_right);

// The scenes that the text speaks of: 500 circles on 640 x 480 pixels, strewn evenly, or around ten
// centres; and the lecture's 8192 on 1024 x 1024, of which a pixel lies in three or four. Release
// with scene2d_free(). Returns 0, or -1 after one message.
int plane_scene_random(Scene2D *scene);
int plane_scene_clusters(Scene2D *scene);
int plane_scene_lecture(Scene2D *scene);

#endif
