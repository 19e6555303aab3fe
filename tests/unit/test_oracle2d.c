// judge/oracle2d: right where right can be worked out by hand, and a tree as lab 02's solution
// grows it.
#include "kdtree2d_build.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "random.h"
#include "scene2d.h"
#include "surroundings.h"

#include <math.h>

TestSuite(oracle2d);

static const OracleRules RIGHT = {0};

// ---- By hand ------------------------------------------------------------------------------------

// The circle that owns a pixel, or -1. Circles carry their index as a colour.
static int winner_at(Circle *circles, int n_circles, const OracleRules *rules, int x, int y)
{
    Image image;
    cr_assert_eq(image_create(16, 12, &image), 0);
    for (int i = 0; i < n_circles; i++) {
        circles[i].r = circles[i].a = (float)(i + 1);
        circles[i].g = circles[i].b = 0.5f;
    }
    // What was there must not shine through.
    memset(image.pixels, 0xff, 16 * 12 * IMAGE_CHANNELS * sizeof(float));
    oracle2d_draw(circles, n_circles, rules, &image, NULL);
    const float *pixel = image.pixels + (y * 16 + x) * IMAGE_CHANNELS;
    const int winner = (int)pixel[0] - 1;
    cr_expect_eq(pixel[3], pixel[0]);
    cr_expect(pixel[1] == (winner < 0 ? 0 : 0.5f) && pixel[2] == pixel[1]);
    image_free(&image);
    return winner;
}

static int is_covered(Circle circle, int x, int y)
{
    const int covered = winner_at(&circle, 1, &RIGHT, x, y) == 0;
    cr_expect_eq(oracle2d_covers(circle, x, y), covered);
    return covered;
}

Test(oracle2d, the_boundary_belongs_to_the_circle)
{
    Circle circle = {.x = 5, .y = 5, .radius = 5};
    static const int on[][2] = {{10, 5}, {0, 5}, {5, 0}, {5, 10}, {8, 9}, {9, 8}, {2, 1}, {1, 2}};
    static const int out[][2] = {{11, 5}, {10, 6}, {9, 9}, {1, 1}, {5, 11}};
    const OracleRules strict = {.strict_boundary = 1};
    for (size_t i = 0; i < sizeof on / sizeof *on; i++) {
        cr_expect(is_covered(circle, on[i][0], on[i][1]), "%zu", i);
        cr_expect_eq(winner_at(&circle, 1, &strict, on[i][0], on[i][1]), -1, "%zu", i);
    }
    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        cr_expect_not(is_covered(circle, out[i][0], out[i][1]), "%zu", i);
    }
    cr_expect_eq(winner_at(&circle, 1, &strict, 9, 7), 0);
}

Test(oracle2d, circles_of_no_size_and_of_any_size)
{
    cr_expect(is_covered((Circle){.x = 3, .y = 4}, 3, 4), "radius 0 on a pixel");
    cr_expect_not(is_covered((Circle){.x = 3, .y = 4}, 4, 4));
    cr_expect_not(is_covered((Circle){.x = 3.5f, .y = 4}, 3, 4));
    cr_expect(is_covered((Circle){.x = 3.5f, .y = 4, .radius = 0.5f}, 3, 4));
    cr_expect(is_covered((Circle){.x = 3.5f, .y = 4, .radius = 0.5f}, 4, 4));
    cr_expect(is_covered((Circle){.x = -100000, .y = 4, .radius = 100003}, 3, 4));
    cr_expect_not(is_covered((Circle){.x = -100000, .y = 4, .radius = 100003}, 3, 5));
    cr_expect_not(is_covered((Circle){.x = -100000, .y = 4, .radius = 100003}, 4, 4));
    cr_expect(is_covered((Circle){.x = 1e20f, .y = 1e20f, .radius = 2e20f}, 0, 11));
    cr_expect_not(is_covered((Circle){.x = 1e20f, .y = 1e20f, .radius = 1e20f}, 15, 11));
}

Test(oracle2d, the_nearest_wins_and_the_first_of_equals)
{
    Circle circles[] = {{.depth = 0.5f},  {.depth = 0.25f}, {.depth = 0.25f},
                        {.depth = 0.75f}, {.depth = 0.75f}, {.depth = 0.5f}};
    static const struct {
        OracleRules rules;
        int winner;
    } cases[] = {{{0}, 1},
                 {{.later_wins_ties = 1}, 2},
                 {{.ignore_depth = 1}, 5},
                 {{.farthest_wins = 1}, 3},
                 {{.first_wins = 1}, 0},
                 {{.first_wins = 1, .skip_first = 1}, 1},
                 {{.ignore_depth = 1, .skip_last = 1}, 4}};
    for (int i = 0; i < 6; i++) {
        circles[i].x = circles[i].y = 6, circles[i].radius = 2;
    }
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        cr_expect_eq(winner_at(circles, 6, &cases[i].rules, 6, 7), cases[i].winner, "case %zu", i);
        cr_expect_eq(winner_at(circles, 6, &cases[i].rules, 9, 7), -1, "case %zu", i);
    }
}

Test(oracle2d, a_depth_may_be_any_number)
{
    Circle circles[] = {{.depth = 0, .radius = 9},
                        {.depth = -128, .radius = 9},
                        {.depth = -INFINITY, .radius = 2},
                        {.depth = INFINITY, .radius = 99}};
    cr_expect_eq(winner_at(circles, 4, &RIGHT, 1, 1), 2);
    cr_expect_eq(winner_at(circles, 4, &RIGHT, 5, 5), 1);
    cr_expect_eq(winner_at(circles, 1, &RIGHT, 5, 5), 0);
    cr_expect_eq(winner_at(circles, 4, &RIGHT, 11, 11), 3, "a circle at infinity is a circle");
}

Test(oracle2d, first_and_last_can_be_the_same_or_nobody)
{
    Circle circle = {.radius = 5};
    cr_expect_eq(winner_at(&circle, 1, &(OracleRules){.skip_first = 1}, 1, 1), -1);
    cr_expect_eq(winner_at(&circle, 1, &(OracleRules){.skip_last = 1}, 1, 1), -1);
    cr_expect_eq(winner_at(&circle, 1, &(OracleRules){.skip_first = 1, .skip_last = 1}, 1, 1), -1);
    cr_expect_eq(winner_at(NULL, 0, &(OracleRules){.skip_first = 1, .skip_last = 1}, 1, 1), -1);
    cr_expect_eq(winner_at(NULL, 0, &RIGHT, 1, 1), -1);
}

Test(oracle2d, samples_and_diameters_can_be_wrong_on_purpose)
{
    Circle point = {.x = 5.5f, .y = 6.5f};
    cr_expect_eq(winner_at(&point, 1, &(OracleRules){.sample_offset = 0.5}, 5, 6), 0);
    cr_expect_eq(winner_at(&point, 1, &(OracleRules){.sample_offset = -0.5}, 6, 7), 0);
    cr_expect_eq(winner_at(&point, 1, &RIGHT, 5, 6), -1);
    Circle circle = {.x = 5, .y = 6, .radius = 4};
    cr_expect_eq(winner_at(&circle, 1, &(OracleRules){.diameter = 1}, 7, 6), 0);
    cr_expect_eq(winner_at(&circle, 1, &(OracleRules){.diameter = 1}, 8, 6), -1);
}

// ---- Circles and boxes --------------------------------------------------------------------------

// The same in whole sixteenths of a pixel, point by point: on this grid the point of a box that is
// nearest to the centre is itself on the grid.
static int overlaps_point_by_point(Circle circle, BBox2D box)
{
    const int64_t x = llrintf(16 * circle.x), y = llrintf(16 * circle.y);
    const int64_t radius = llrintf(16 * circle.radius);
    for (int64_t v = llrintf(16 * box.minY); v <= llrintf(16 * box.maxY); v++) {
        for (int64_t u = llrintf(16 * box.minX); u <= llrintf(16 * box.maxX); u++) {
            if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius) {
                return 1;
            }
        }
    }
    return 0;
}

static float sixteenths(Random *random, int64_t lowest, int64_t highest)
{
    return (float)random_integer(random, lowest, highest) / 16;
}

Test(oracle2d, circles_overlap_boxes_as_point_by_point)
{
    Random random = {3};
    int n_overlaps = 0;
    for (int i = 0; i < 20000; i++) {
        BBox2D box = {.minX = sixteenths(&random, -99, 99), .minY = sixteenths(&random, -99, 99)};
        box.maxX = box.minX + sixteenths(&random, 0, 40);
        box.maxY = box.minY + sixteenths(&random, 0, 40);
        const Circle circle = {.x = sixteenths(&random, -150, 190),
                               .y = sixteenths(&random, -150, 190),
                               .radius = sixteenths(&random, 0, i % 2 ? 30 : 120)};
        const int expected = overlaps_point_by_point(circle, box);
        n_overlaps += expected;
        cr_assert_eq(oracle2d_overlaps_box(circle, box), expected,
                     "circle (%g, %g) %g, box [%g, %g] [%g, %g]", (double)circle.x,
                     (double)circle.y, (double)circle.radius, (double)box.minX, (double)box.maxX,
                     (double)box.minY, (double)box.maxY);
    }
    cr_expect(n_overlaps > 1500 && n_overlaps < 18500, "%d", n_overlaps);
}

Test(oracle2d, touching_a_box_is_overlapping_it)
{
    const BBox2D box = {10, 20, 30, 34};
    static const float step = 1.0f / 16;
    // A direction away from the box and a point of it; the circle's centre lies `radius` away.
    static const struct {
        float x, y, away_x, away_y, radius;
    } cases[] = {{10, 32, -2, 0, 2},   {20, 34, 2, 0, 2},   {15, 30, 0, -7, 7},
                 {15, 34, 0, 7, 7},    {10, 30, -3, -4, 5}, {20, 34, 12, 5, 13},
                 {10, 34, -8, 15, 17}, {20, 30, 7, -24, 25}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Circle circle = {.x = cases[i].x + cases[i].away_x,
                         .y = cases[i].y + cases[i].away_y,
                         .radius = cases[i].radius};
        cr_expect(oracle2d_overlaps_box(circle, box), "case %zu", i);
        circle.radius -= step;
        cr_expect_not(oracle2d_overlaps_box(circle, box), "case %zu", i);
        circle.radius += step;
        circle.x += cases[i].away_x > 0 ? step : cases[i].away_x < 0 ? -step : 0;
        circle.y += cases[i].away_y > 0 ? step : cases[i].away_y < 0 ? -step : 0;
        cr_expect_not(oracle2d_overlaps_box(circle, box), "case %zu", i);
    }
    cr_expect(oracle2d_overlaps_box((Circle){.x = 15, .y = 32}, box), "a point inside");
    cr_expect(oracle2d_overlaps_box((Circle){.x = 10, .y = 30}, box), "a point on its corner");
    cr_expect(oracle2d_overlaps_box((Circle){.x = 15, .y = 32, .radius = 99}, box), "all of it");
    cr_expect_not(oracle2d_overlaps_box((Circle){.x = 1e30f, .y = 32, .radius = 99}, box));
}

// ---- The tree -----------------------------------------------------------------------------------

// It shares no code with lab 02, and must come out the same.
static void expect_solutions_tree(const char *name, int width, int height, KdTreeLimits limits)
{
    Scene2D scene;
    KdTree2D own, tree;
    cr_assert_eq(scene2d_open(name, width, height, &scene), 0);
    cr_assert_eq(kdtree2d_build(scene.circles, (u32)scene.n_circles, limits, &own), 0);
    Growth growth = {0};
    cr_assert_eq(oracle2d_tree(&scene, 0, limits, &growth, &tree), 0);
    growth_free(&growth);
    cr_assert_eq(own.n_nodes, tree.n_nodes, "%s", name);
    cr_assert_eq(own.n_map, tree.n_map, "%s", name);
    cr_expect_eq(memcmp(own.nodes_Relations, tree.nodes_Relations, own.n_nodes * sizeof(NodeRel)),
                 0, "%s", name);
    cr_expect_eq(memcmp(own.nodes_flag, tree.nodes_flag, own.n_nodes), 0, "%s", name);
    cr_expect_eq(memcmp(own.nodes_BBox, tree.nodes_BBox, own.n_nodes * sizeof(BBox2D)), 0, "%s",
                 name);
    cr_expect_eq(memcmp(own.mapNode2Circles, tree.mapNode2Circles, own.n_map * sizeof(u32)), 0,
                 "%s", name);
    tree2d_free(&own);
    tree2d_free(&tree);
    scene2d_free(&scene);
}

Test(oracle2d, the_tree_is_the_solutions)
{
    static const char *const names[] = {"example", "touching", "tiny", "none", "borders"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        expect_solutions_tree(names[i], 64, 48, (KdTreeLimits){1 + (int)i, 1});
        expect_solutions_tree(names[i], 48, 64, (KdTreeLimits){9, 2});
    }
    for (int seed = 0; seed < 30; seed++) {
        char name[64];
        snprintf(name, sizeof name, "random:n=%d,seed=%d", 10 * seed, seed);
        expect_solutions_tree(name, 200, 100 + 7 * seed,
                              (KdTreeLimits){1 + seed % 10, 1 + seed % 6});
    }
}
