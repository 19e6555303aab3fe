// 02-failed-split.svg: what a split makes of ten circles, and whether it has failed.
#include "figures2d.h"

#include "kdtree2d_build.h"
#include "kdtree_limits.h"

// Panels side by side. Pixels.
enum { TOP = 96, LEFT = 24, SIDE = 300, GAP = 38, N_CIRCLES = 10, N_PANELS = 3, HEIGHT = 480 };

static const BBox2D CELL = {0, 10, 0, 8};

// How many of each panel's circles are on the plane; and where the others are, on both sides of it.
static const int N_ON_PLANE[N_PANELS] = {10, 8, 1};
static const f32 BESIDE[N_CIRCLES - 1][2] = {{1.25f, 1.25f}, {2, 3},         {1.25f, 4.75f},
                                             {6.75f, 1.5f},  {8.75f, 3},     {7.25f, 4.5f},
                                             {3.25f, 6},     {1.25f, 6.75f}, {8.5f, 6.5f}};

static Circle circle_of(int panel, int i)
{
    return i < N_ON_PLANE[panel]
               ? (Circle){.x = 4.5f + 0.5f * (i % 3), .y = 3.25f + 0.5f * (i / 3), .radius = 1.5f}
               : (Circle){.x = BESIDE[i - 1][0], .y = BESIDE[i - 1][1], .radius = 0.75f};
}

static u32 n_overlapping(int panel, BBox2D cell)
{
    u32 n = 0;
    for (int i = 0; i < N_CIRCLES; i++) {
        n += circle_overlaps_box(circle_of(panel, i), cell);
    }
    return n;
}

static void panel_draw(FILE *file, int panel, double left)
{
    const double scale = SIDE / (double)CELL.maxX, bottom = TOP + CELL.maxY * scale;
    BBox2D low, high;
    split_box(CELL, &low, &high);
    svg_box(file, left, TOP, SIDE, bottom - TOP,
            "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    for (int i = 0; i < N_CIRCLES; i++) {
        const Circle circle = circle_of(panel, i);
        svg_circle(file, left + circle.x * scale, TOP + circle.y * scale, circle.radius * scale,
                   "fill=\"" SVG_SKY "\" fill-opacity=\"0.5\" stroke=\"" SVG_BLUE
                   "\" stroke-width=\"2\"");
    }
    const double plane = left + low.maxX * scale;
    svg_line(file, plane, TOP - 8, plane, bottom + 8,
             "stroke=\"" SVG_ORANGE "\" stroke-width=\"4\" stroke-dasharray=\"9 6\"");
    const u32 n_low = n_overlapping(panel, low), n_high = n_overlapping(panel, high);
    svg_text(file, (left + plane) / 2, bottom + 34, SVG_MIDDLE, "", "left: %u", n_low);
    svg_text(file, (plane + left + SIDE) / 2, bottom + 34, SVG_MIDDLE, "", "right: %u", n_high);
    svg_title(file, left + SIDE / 2.0, bottom + 76, SVG_MIDDLE, "", "%u + %u = %u: %s", n_low,
              n_high, n_low + n_high,
              split_failed(N_CIRCLES, n_low, n_high) ? "failed" : "it helps");
}

void draw_failed(FILE *file, const Followed *followed)
{
    (void)followed;
    svg_begin(file, HEIGHT, "Failed splits",
              "Three cells with ten circles each, split in the middle. If all circles are on the "
              "plane, both children keep ten: failed. If eight are, both keep nine: failed, too. "
              "If one is, they keep six and five: the split helps.");
    svg_title(file, LEFT, 44, SVG_LEFT, "", "Ten circles, split in the middle");
    for (int i = 0; i < N_PANELS; i++) {
        panel_draw(file, i, LEFT + i * (SIDE + GAP));
    }
    svg_text(file, LEFT, HEIGHT - 24, SVG_LEFT, "",
             "Failed: 18 or more together, 9/5 of its list. Under 4 failed splits: a leaf.");
    svg_end(file);
}
