// 10-realtime/circle_tree: what the lists of the leaves leave out is seen in no pixel, whichever
// way a device rounds; and colours are those of a PNG.
#include "circle_tree.h"
#include "random.h"
#include "surroundings.h"

#include <math.h>

TestSuite(circle_tree);

enum { SIDE = 3 * CIRCLE_TILE_SIDE, N_CIRCLES = 40 };

static float anywhere(Random *random, double lowest, double highest)
{
    return (float)(lowest + (highest - lowest) * (double)(random_bits(random) >> 11) * 0x1p-53);
}

// The first or the last pixel of a random tile, the nearer one to a point or the farther one.
static float tile_border(Random *random, float from, int is_farther)
{
    const int64_t tile = random_integer(random, 0, SIDE / CIRCLE_TILE_SIDE - 1);
    const float first = (float)(tile * CIRCLE_TILE_SIDE), last = first + CIRCLE_TILE_SIDE - 1;
    return (fabsf(from - first) > fabsf(from - last)) == is_farther ? first : last;
}

// Circles off the grid of 1/16 px whose boundaries pass as near to the corner of a tile as a float
// radius can say: circles that only just reach it, and some that only just cover it.
static void draw_off_grid(Random *random, Circle circles[N_CIRCLES])
{
    for (int i = 0; i < N_CIRCLES; i++) {
        const int covers_tile = i % 2;
        const float x = anywhere(random, -9, SIDE + 9), y = anywhere(random, -9, SIDE + 9);
        const float radius = hypotf(tile_border(random, x, covers_tile) - x,
                                    tile_border(random, y, covers_tile) - y);
        circles[i] = (Circle){.x = x, .y = y, .radius = radius, .r = (float)(i + 1) / 255};
        circles[i].depth = (float)random_integer(random, 0, 99);
    }
}

// The ways in which a device may round: with and without contraction.
enum { N_WAYS = 3 };
static int covers(int way, float dx, float dy, float radius_squared)
{
    return (way == 0   ? dx * dx + dy * dy
            : way == 1 ? fmaf(dx, dx, dy * dy)
                       : fmaf(dy, dy, dx * dx)) <= radius_squared;
}

static u32 color_of_all(int way, const Circle *circles, int x, int y)
{
    const Circle *found = NULL;
    for (const Circle *c = circles; c < circles + N_CIRCLES; c++) {
        if (covers(way, (float)x - c->x, (float)y - c->y, c->radius * c->radius) &&
            (found == NULL || c->depth < found->depth)) {
            found = c;
        }
    }
    return found == NULL ? 0 : (u32)(found - circles) + 1;
}

static u32 color_of_leaf(int way, const CircleTree *tree, int x, int y)
{
    TileNode node = tree->nodes[0];
    while (node.split_axis != KD_LEAF) {
        node = tree->nodes[node.first + ((node.split_axis == 0 ? x : y) >= node.split_pos)];
    }
    for (u32 i = node.first; i < node.first + node.n_circles; i++) {
        const TileCircle c = tree->leaf_circles[i];
        if (covers(way, (float)x - c.x, (float)y - c.y, c.radius_squared)) {
            return c.color;
        }
    }
    return 0;
}

Test(circle_tree, every_pixel_shows_what_all_circles_show)
{
    Random random = {7};
    for (int round = 0; round < 300; round++) {
        Circle circles[N_CIRCLES];
        draw_off_grid(&random, circles);
        const Scene2D scene = {.circles = circles, N_CIRCLES, SIDE, SIDE};
        CircleTree tree;
        cr_assert_eq(circle_tree_build(&scene, (KdTreeLimits){64, 1}, &tree), 0);
        for (int i = 0; i < N_WAYS * SIDE * SIDE; i++) {
            const int way = i % N_WAYS, x = i / N_WAYS % SIDE, y = i / N_WAYS / SIDE;
            const u32 found = color_of_leaf(way, &tree, x, y);
            const u32 expected = color_of_all(way, circles, x, y);
            cr_expect_eq(found, expected, "round %d, way %d, pixel (%d, %d): found %u, expected %u",
                         round, way, x, y, found, expected);
        }
        circle_tree_free(&tree);
    }
}

Test(circle_tree, what_a_circle_hides_is_left_out)
{
    // The nearer covers the picture whole, with room to spare.
    Circle circles[] = {{.x = 8, .y = 8, .radius = 9, .depth = 1},
                        {.x = 7.5f, .y = 7.5f, .radius = 10.7f, .depth = 0.5f}};
    const Scene2D scene = {.circles = circles, 2, CIRCLE_TILE_SIDE, CIRCLE_TILE_SIDE};
    CircleTree tree;
    cr_assert_eq(circle_tree_build(&scene, (KdTreeLimits){64, 1}, &tree), 0);
    cr_expect_eq(tree.n_leaf_circles, 1);
    circle_tree_free(&tree);
}

// 76.5, 127.5 and 178.5 are between two bytes: the even one is taken, as in a PNG (test_image).
Test(circle_tree, colors_are_rounded_as_in_a_png)
{
    Circle circle = {8, 8, 1, 0, 0.3f, 0.5f, 0.7f, 2};
    const Scene2D scene = {.circles = &circle, 1, CIRCLE_TILE_SIDE, CIRCLE_TILE_SIDE};
    CircleTree tree;
    cr_assert_eq(circle_tree_build(&scene, (KdTreeLimits){64, 1}, &tree), 0);
    cr_expect_eq(tree.leaf_circles[0].color, 76u | 128u << 8 | 178u << 16 | 255u << 24);
    circle_tree_free(&tree);
}
