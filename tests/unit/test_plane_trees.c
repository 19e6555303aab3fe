// The trees that the 3D notes compare in two dimensions: what they are expected to cost, counted
// another way.
#include "plane_trees.h"

#include "kdtree2d_build.h"
#include "options.h"
#include "surroundings.h"

#include <math.h>

// What rounding in double may add up to over some hundred nodes.
static const double ROUNDING = 1e-9;

static const PlaneRule MIDDLE = {NO_WEIGHT, NO_WEIGHT}, BY_AREA = {AREA, AREA},
                       BY_PERIMETER = {PERIMETER, PERIMETER};

static double area_of(BBox2D box)
{
    return ((double)box.maxX - box.minX) * ((double)box.maxY - box.minY);
}

static Scene2D open_scene(int (*make)(Scene2D *))
{
    Scene2D scene;
    cr_assert_eq(make(&scene), 0);
    return scene;
}

Test(plane_trees, a_split_by_hand)
{
    // 8 x 4, cut at x = 2: areas 8 and 24 of 32, perimeters 12 and 20 of 24.
    const BBox2D cell = {0, 8, 0, 4}, left = {0, 2, 0, 4}, right = {2, 8, 0, 4};
    cr_expect_eq(plane_split_cost(AREA, cell, left, right, 3, 1), 1 + (24.0 + 24) / 32);
    cr_expect_float_eq(plane_split_cost(PERIMETER, cell, left, right, 3, 1), 1 + (36.0 + 20) / 24,
                       ROUNDING);
}

Test(plane_trees, the_middle_is_lab_02s_tree)
{
    Scene2D scene = open_scene(plane_scene_random);
    PlaneTree tree = plane_tree_grow(&scene, MIDDLE);
    KdTree2D expected;
    const KdTreeLimits limits = {OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};
    cr_assert_eq(kdtree2d_build(scene.circles, (u32)scene.n_circles, limits, &expected), 0);
    u32 n_leaves = 0;
    double steps = 0, tests = 0;
    for (u32 id = 0; id < expected.n_nodes; id++) {
        const double share = area_of(expected.nodes_BBox[id]) / area_of(expected.nodes_BBox[0]);
        if (expected.nodes_flag[id] == INNER) {
            steps += share;
        } else {
            tests += share * expected.mapNode2Circles[expected.nodes_Relations[id].circleMapOffset];
            n_leaves++;
        }
    }
    cr_expect_eq(tree.n_leaves, n_leaves);
    cr_expect_float_eq(tree.steps, steps, ROUNDING);
    cr_expect_float_eq(tree.tests, tests, ROUNDING);
    tree2d_free(&expected);
    plane_tree_free(&tree);
    scene2d_free(&scene);
}

Test(plane_trees, leaves_hold_the_plane_and_what_overlaps_them)
{
    Scene2D scene = open_scene(plane_scene_clusters);
    const PlaneRule rules[] = {MIDDLE, BY_AREA, BY_PERIMETER};
    for (int rule = 0; rule < 3; rule++) {
        PlaneTree tree = plane_tree_grow(&scene, rules[rule]);
        double area = 0, tests = 0;
        for (u32 leaf = 0; leaf < tree.n_leaves; leaf++) {
            u32 n = 0;
            for (int i = 0; i < scene.n_circles; i++) {
                n += (u32)circle_overlaps_box(scene.circles[i], tree.leaves[leaf]);
            }
            area += area_of(tree.leaves[leaf]);
            tests += area_of(tree.leaves[leaf]) / area_of(tree.root) * n;
        }
        // Planes are floats: a child's side is off by a float's last place at most.
        cr_expect_float_eq(area / area_of(tree.root), 1, 1e-5, "rule %d: %g", rule, area);
        cr_expect_float_eq(tree.tests, tests, ROUNDING, "rule %d: found %g, expected %g", rule,
                           tree.tests, tests);
        plane_tree_free(&tree);
    }
    scene2d_free(&scene);
}

// Steps and tests together.
static double cost_of(const Scene2D *scene, PlaneRule rule)
{
    PlaneTree tree = plane_tree_grow(scene, rule);
    const double cost = tree.steps + tree.tests;
    plane_tree_free(&tree);
    return cost;
}

// For lines it is the perimeter.
Test(plane_trees, the_perimeter_is_the_weight_of_a_line)
{
    Scene2D scene = open_scene(plane_scene_random);
    PlaneTree area = plane_tree_grow(&scene, BY_AREA);
    PlaneTree perimeter = plane_tree_grow(&scene, BY_PERIMETER);
    cr_expect_lt(perimeter.line_sum, area.line_sum);
    // A line meets more cells than the one that a point is in.
    cr_expect_gt(perimeter.line_sum, perimeter.steps + perimeter.tests);
    plane_tree_free(&area);
    plane_tree_free(&perimeter);
    scene2d_free(&scene);
}

// What the notes say of their scenes: the area is the best everywhere; the perimeter may be
// worse than the middle.
Test(plane_trees, the_area_is_the_weight_of_a_point)
{
    int (*const makes[])(Scene2D *) = {plane_scene_random, plane_scene_clusters,
                                       plane_scene_lecture};
    for (int i = 0; i < 3; i++) {
        Scene2D scene = open_scene(makes[i]);
        const double area = cost_of(&scene, BY_AREA), middle = cost_of(&scene, MIDDLE);
        const double perimeter = cost_of(&scene, BY_PERIMETER);
        cr_expect_lt(area, middle);
        cr_expect_lt(area, perimeter);
        cr_expect_eq(perimeter < middle, i < 2, "scene %d: %g, %g", i, perimeter, middle);
        scene2d_free(&scene);
    }
}
