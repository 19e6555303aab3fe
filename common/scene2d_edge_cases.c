// The lecture's example and the edge cases: small scenes, each made to catch one kind of mistake.
//
// All coordinates are whole steps of 1/16 px (see scene2d.h why). What a scene is for stands above
// its function. Read next: scene2d_random.c.
#include "scene2d_edge_cases.h"

#include "random.h"

#include <assert.h>
#include <stddef.h>

static int smaller_of(int a, int b)
{
    return a < b ? a : b;
}

static int larger_of(int a, int b)
{
    return a > b ? a : b;
}

// Add a circle in the next of twelve clear colours. A scene has room for every circle of its case.
static void add_circle(Scene2D *scene, float x, float y, float radius, float depth)
{
    static const float COLOURS[][3] = {
        {0.90f, 0.10f, 0.10f}, {0.10f, 0.60f, 0.10f}, {0.15f, 0.35f, 0.95f}, {1.00f, 0.85f, 0.10f},
        {0.95f, 0.95f, 0.95f}, {0.80f, 0.20f, 0.80f}, {0.10f, 0.80f, 0.80f}, {1.00f, 0.50f, 0.05f},
        {0.55f, 0.35f, 0.20f}, {0.60f, 0.85f, 0.30f}, {0.95f, 0.60f, 0.75f}, {0.50f, 0.50f, 0.60f},
    };
    const size_t n_colours = sizeof COLOURS / sizeof COLOURS[0];
    assert(scene->n_circles < SCENE2D_EDGE_CASE_CIRCLES);
    const float *colour = COLOURS[(size_t)scene->n_circles % n_colours];
    scene->circles[scene->n_circles++] =
        (Circle){x, y, radius, depth, colour[0], colour[1], colour[2], 1};
}

// The depth of the next circle when each one lies behind those before it.
static float depth_behind_all(const Scene2D *scene)
{
    return (float)(scene->n_circles + 1) / 1024;
}

// The lecture's worked example, A to E. With leaves of one circle and four levels, every node of
// the first three levels is split, and the search for pixel (7, 7) ends in node 13, which holds C
// and E: C covers the pixel, E does not. No two of the circles overlap.
static void draw_example(Scene2D *scene)
{
    add_circle(scene, 2.5f, 2.5f, 2.0f, 0.5f);     // A
    add_circle(scene, 3.0f, 7.5f, 1.75f, 0.375f);  // B
    add_circle(scene, 6.5f, 7.0f, 1.75f, 0.625f);  // C
    add_circle(scene, 7.5f, 2.5f, 1.875f, 0.75f);  // D
    add_circle(scene, 5.0f, 4.5f, 1.0f, 0.25f);    // E
}

// Ties: 120 overlapping circles at three depths. Almost everywhere the lowest index among equals
// decides, so `<=` for `<`, or a tree that visits circles out of order, shows at once.
static void draw_equal_depths(Scene2D *scene)
{
    Random random = {2};
    int shorter_side = smaller_of(scene->width, scene->height);
    int smallest = smaller_of(shorter_side * 2, SCENE2D_MAX_RADIUS * SCENE2D_STEPS_PER_PIXEL / 2);
    for (int i = 0; i < 120; i++) {
        int64_t x = random_integer(&random, 0, (int64_t)scene->width * SCENE2D_STEPS_PER_PIXEL);
        int64_t y = random_integer(&random, 0, (int64_t)scene->height * SCENE2D_STEPS_PER_PIXEL);
        int64_t radius = random_integer(&random, smallest, smallest * 2);
        float depth = (float)random_integer(&random, 1, 3) / 4;
        add_circle(scene, (float)x / SCENE2D_STEPS_PER_PIXEL, (float)y / SCENE2D_STEPS_PER_PIXEL,
                   (float)radius / SCENE2D_STEPS_PER_PIXEL, depth);
    }
}

// Boundaries that pass exactly through pixels: whole centres, on corners and borders too, and radii
// that have whole points off the axes (3-4-5, 5-12-13, 7-24-25, 33-56-65): `<` for `<=` shows.
static void draw_borders(Scene2D *scene)
{
    static const int RADII[] = {1, 5, 13, 25, 65, 85};
    int shorter_side = smaller_of(scene->width, scene->height);
    for (size_t i = 0; i < sizeof RADII / sizeof RADII[0]; i++) {
        if (RADII[i] > 1 && RADII[i] * 2 > shorter_side) {
            break;
        }
        for (int position = 0; position < 9; position++) {
            int x = (scene->width - 1) * (position % 3) / 2;
            int y = (scene->height - 1) * (position / 3) / 2;
            add_circle(scene, (float)x, (float)y, (float)RADII[i], depth_behind_all(scene));
        }
    }
}

// Circles that touch in single points, all at one depth: the pixel where two touch belongs to the
// lower index. One pair touches on a slant (3-4-5); a lattice touches at whole points.
static void draw_touching(Scene2D *scene)
{
    const float depth = 0.5f;
    float middle_x = (float)(scene->width / 2);
    float middle_y = (float)(scene->height / 2);
    add_circle(scene, middle_x - 3, middle_y - 4, 5, depth);
    add_circle(scene, middle_x + 3, middle_y + 4, 5, depth);

    int shorter_side = smaller_of(scene->width, scene->height);
    int radius = larger_of(1, smaller_of(shorter_side / 8, SCENE2D_MAX_RADIUS));
    int n_columns = smaller_of(scene->width / (2 * radius), 15);
    int n_rows = smaller_of(scene->height / (2 * radius), 15);
    for (int row = 0; row < n_rows; row++) {
        for (int column = 0; column < n_columns; column++) {
            float x = (float)(radius + 2 * radius * column);
            float y = (float)(radius + 2 * radius * row);
            // A circle inside the other, touching it on the left; first, so that it is seen.
            if ((row + column) % 2 == 0) {
                add_circle(scene, x - (float)radius / 2, y, (float)radius / 2, depth);
            }
            add_circle(scene, x, y, (float)radius, depth);
        }
    }
}

// Radii many times the picture. Some cover all of it, some none; their boundaries keep far away
// from the pixels, where float could not tell them apart. Five usual circles lie in front.
static void draw_huge(Scene2D *scene)
{
    int longer_side = larger_of(scene->width, scene->height);
    float huge = (float)larger_of(100000, 4 * longer_side);
    float middle_x = (float)(scene->width / 2);
    float middle_y = (float)(scene->height / 2);
    add_circle(scene, middle_x, middle_y, huge, 0.9375f);
    add_circle(scene, -huge / 2, middle_y, huge, 0.875f);              // covers all, nearer
    add_circle(scene, middle_x, middle_y - huge / 2, huge, 0.96875f);  // covers all, hidden
    add_circle(scene, -huge - 1000, middle_y, huge, 0.0625f);          // ends left of the picture
    add_circle(scene, middle_x, -2 * huge, huge, 0.0625f);             // far above it

    int shorter_side = smaller_of(scene->width, scene->height);
    float radius = (float)smaller_of(larger_of(shorter_side / 3, 1), SCENE2D_MAX_RADIUS);
    add_circle(scene, middle_x, middle_y, radius, 0.5f);
    for (int corner = 0; corner < 4; corner++) {
        add_circle(scene, (float)(scene->width * (corner % 2)),
                   (float)(scene->height * (corner / 2)), radius, 0.25f);
    }
}

// One row for each way of being small. Radius 0 on a pixel covers that pixel and no other; between
// pixels it covers none, and radius 1/2 between two of them covers both, just so.
static void draw_tiny(Scene2D *scene)
{
    static const struct {
        float radius;
        float shift_x;  // away from the pixel
        float shift_y;
    } KINDS[] = {
        {0.0f, 0.0f, 0.0f},    {0.0625f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.0f},    {0.5f, 0.5f, 0.0f},
        {0.0625f, 0.5f, 0.5f}, {0.0f, 0.5f, 0.0f},    {0.4375f, 0.5f, 0.0f}, {1.0f, 0.0f, 0.0f},
    };
    const int n_kinds = (int)(sizeof KINDS / sizeof KINDS[0]);
    const int n_columns = 12;
    for (int kind = 0; kind < n_kinds; kind++) {
        for (int column = 0; column < n_columns; column++) {
            int64_t x = (int64_t)(scene->width - 1) * column / (n_columns - 1);
            int64_t y = (int64_t)(scene->height - 1) * kind / (n_kinds - 1);
            add_circle(scene, (float)x + KINDS[kind].shift_x, (float)y + KINDS[kind].shift_y,
                       KINDS[kind].radius, depth_behind_all(scene));
        }
    }
}

// One circle beyond a border. It reaches `reach` pixels into the picture, none when negative.
static void add_beyond_border(Scene2D *scene, int border, float radius, float reach)
{
    float middle_x = (float)(scene->width / 2);
    float middle_y = (float)(scene->height / 2);
    float distance = radius - reach;
    switch (border) {
    case 0:
        add_circle(scene, -distance, middle_y, radius, depth_behind_all(scene));
        break;
    case 1:
        add_circle(scene, (float)(scene->width - 1) + distance, middle_y, radius,
                   depth_behind_all(scene));
        break;
    case 2:
        add_circle(scene, middle_x, -distance, radius, depth_behind_all(scene));
        break;
    default:
        add_circle(scene, middle_x, (float)(scene->height - 1) + distance, radius,
                   depth_behind_all(scene));
        break;
    }
}

// Circles beyond the four borders: far away, missing the first pixel by 1/16, touching exactly one
// pixel, reaching in; and beyond the corners. Bounds that forget them, or clip them, lose pixels.
static void draw_outside(Scene2D *scene)
{
    int shorter_side = smaller_of(scene->width, scene->height);
    float radius = (float)smaller_of(larger_of(shorter_side / 4, 1), SCENE2D_MAX_RADIUS);
    for (int border = 0; border < 4; border++) {
        add_beyond_border(scene, border, 5, 0);
        add_beyond_border(scene, border, 5, -1.0f / SCENE2D_STEPS_PER_PIXEL);
        add_beyond_border(scene, border, radius, -4 * radius);
        add_beyond_border(scene, border, radius, radius / 2);
    }
    for (int corner = 0; corner < 4; corner++) {
        int right = corner % 2;
        int bottom = corner / 2;
        // Whole points 3 and 4 away from the corner pixel touch it with radius 5.
        float x = right ? (float)(scene->width - 1 + 3) : -3.0f;
        float y = bottom ? (float)(scene->height - 1 + 4) : -4.0f;
        add_circle(scene, x, y, 5, depth_behind_all(scene));
        add_circle(scene, 2 * x, 2 * y, 5, depth_behind_all(scene));
    }
}

// No circle at all: every pixel is background, and the tree is one empty leaf.
static void draw_none(Scene2D *scene)
{
    (void)scene;
}

const SceneEdgeCase SCENE2D_EDGE_CASES[] = {
    {"example", draw_example, 10, 10},
    {"equal-depths", draw_equal_depths, 0, 0},
    {"borders", draw_borders, 0, 0},
    {"touching", draw_touching, 0, 0},
    {"huge", draw_huge, 0, 0},
    {"tiny", draw_tiny, 0, 0},
    {"outside", draw_outside, 0, 0},
    {"none", draw_none, 0, 0},
    {NULL, NULL, 0, 0},
};
