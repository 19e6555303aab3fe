// 00-work-groups.svg: groups that hang over the picture. 01-sample-point.svg: where a pixel asks.
#include "figures2d.h"

#include "oracle2d.h"
#include "render.h"

// ---- Work-groups --------------------------------------------------------------------------------

// A picture that no whole number of groups fits, and how large a work-item is drawn. Pixels.
enum { WIDTH = 37, HEIGHT = 21, ITEM = 13, LEFT = 200, TOP = 96 };

static int groups_of(int n_pixels)
{
    return (n_pixels + GROUP_SIZE - 1) / GROUP_SIZE;
}

void draw_groups(FILE *file, const Followed *followed)
{
    (void)followed;
    const int columns = groups_of(WIDTH) * GROUP_SIZE, rows = groups_of(HEIGHT) * GROUP_SIZE;
    const double right = LEFT + columns * ITEM, bottom = TOP + rows * ITEM;
    const char *thin = "stroke=\"" SVG_GREY "\" stroke-width=\"0.7\"";
    svg_begin(
        file, TOP + rows * ITEM + 56, "Work-groups hang over the picture",
        "A picture of 37 by 21 pixels is covered by three by two groups of 16 by 16 work-items. "
        "The "
        "work-items to the right of the picture and below it, nearly half of all, have no pixel.");
    svg_title(file, LEFT, 40, SVG_LEFT, "", "%d x %d pixels, %d x %d groups of %d x %d work-items",
              WIDTH, HEIGHT, groups_of(WIDTH), groups_of(HEIGHT), GROUP_SIZE, GROUP_SIZE);
    svg_box(file, LEFT, TOP, WIDTH * ITEM, HEIGHT * ITEM, "fill=\"" SVG_SKY "\"");
    for (int x = 1; x < columns; x++) {
        svg_line(file, LEFT + x * ITEM, TOP, LEFT + x * ITEM, bottom, thin);
    }
    for (int y = 1; y < rows; y++) {
        svg_line(file, LEFT, TOP + y * ITEM, right, TOP + y * ITEM, thin);
    }
    for (int group = 0; group <= groups_of(WIDTH); group++) {
        const double x = LEFT + group * GROUP_SIZE * ITEM;
        svg_line(file, x, TOP, x, bottom, "stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
        svg_text(file, x, TOP - 12, SVG_MIDDLE, "", "%d", group * GROUP_SIZE);
    }
    for (int group = 0; group <= groups_of(HEIGHT); group++) {
        const double y = TOP + group * GROUP_SIZE * ITEM;
        svg_line(file, LEFT, y, right, y, "stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
        svg_text(file, LEFT - 10, y + 7, SVG_RIGHT, "", "%d", group * GROUP_SIZE);
    }
    svg_box(file, LEFT, TOP, WIDTH * ITEM, HEIGHT * ITEM,
            "fill=\"none\" stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
    svg_text(file, LEFT + 1.5 * GROUP_SIZE * ITEM, TOP + HEIGHT * ITEM / 2.0, SVG_MIDDLE, SVG_HALO,
             "the picture");
    svg_text(file, LEFT, bottom + 36, SVG_LEFT, "",
             "%d x %d = %d work-items start; the %d white ones have no pixel", columns, rows,
             columns * rows, columns * rows - WIDTH * HEIGHT);
    svg_end(file);
}

// ---- Sample points ------------------------------------------------------------------------------

// A circle that passes through sample points, and what it covers.
static const char COVERED[] = "(x − cx)² + (y − cy)² ≤ r²";
static const Circle CIRCLE = {.x = 4, .y = 3, .radius = 2};
enum { SAMPLE_COLUMNS = 8, SAMPLE_ROWS = 6, PIXEL = 82, SAMPLE_LEFT = 60, SAMPLE_TOP = 110 };

static void sample_draw(FILE *file, int x, int y)
{
    const double left = SAMPLE_LEFT + x * PIXEL, top = SAMPLE_TOP + y * PIXEL;
    const int is_covered = oracle2d_covers(CIRCLE, x, y);
    svg_circle(file, left, top, is_covered ? 9 : 6,
               is_covered ? "fill=\"" SVG_BLACK "\""
                          : "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
}

void draw_sample(FILE *file, const Followed *followed)
{
    (void)followed;
    svg_begin(file, SAMPLE_TOP + (SAMPLE_ROWS - 1) * PIXEL + 70, "A pixel's sample point",
              "A grid of points, one a pixel, at whole-numbered coordinates, x to the right and y "
              "down. A "
              "circle about the point 4, 3 with radius 2 covers 13 of them: the four on its "
              "boundary, too.");
    svg_title(file, 24, 40, SVG_LEFT, "", "A pixel is tested at its whole-numbered coordinate");
    for (int y = 0; y < SAMPLE_ROWS; y++) {
        svg_text(file, SAMPLE_LEFT - 18, SAMPLE_TOP + y * PIXEL + 7, SVG_RIGHT, "", "%d", y);
        svg_line(file, SAMPLE_LEFT, SAMPLE_TOP + y * PIXEL,
                 SAMPLE_LEFT + (SAMPLE_COLUMNS - 1) * PIXEL, SAMPLE_TOP + y * PIXEL,
                 "stroke=\"" SVG_PALE "\"");
    }
    for (int x = 0; x < SAMPLE_COLUMNS; x++) {
        svg_text(file, SAMPLE_LEFT + x * PIXEL, SAMPLE_TOP - 22, SVG_MIDDLE, "", "%d", x);
        svg_line(file, SAMPLE_LEFT + x * PIXEL, SAMPLE_TOP, SAMPLE_LEFT + x * PIXEL,
                 SAMPLE_TOP + (SAMPLE_ROWS - 1) * PIXEL, "stroke=\"" SVG_PALE "\"");
    }
    svg_circle(
        file, SAMPLE_LEFT + CIRCLE.x * PIXEL, SAMPLE_TOP + CIRCLE.y * PIXEL, CIRCLE.radius * PIXEL,
        "fill=\"" SVG_SKY "\" fill-opacity=\"0.7\" stroke=\"" SVG_BLUE "\" stroke-width=\"3\"");
    for (int y = 0; y < SAMPLE_ROWS; y++) {
        for (int x = 0; x < SAMPLE_COLUMNS; x++) {
            sample_draw(file, x, y);
        }
    }
    const double words = SAMPLE_LEFT + (SAMPLE_COLUMNS - 1) * PIXEL + 40;
    svg_circle(file, words, SAMPLE_TOP + 60, 9, "fill=\"" SVG_BLACK "\"");
    svg_text(file, words + 22, SAMPLE_TOP + 66, SVG_LEFT, "", "covered:");
    svg_text(file, words + 22, SAMPLE_TOP + 94, SVG_LEFT, "", "%s", COVERED);
    svg_circle(file, words, SAMPLE_TOP + 140, 6,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    svg_text(file, words + 22, SAMPLE_TOP + 146, SVG_LEFT, "", "not covered");
    svg_text(file, words - 10, SAMPLE_TOP + 220, SVG_LEFT, "", "(%g, %g): %g² + 0² = r²,",
             CIRCLE.x + CIRCLE.radius, CIRCLE.y, CIRCLE.radius);
    svg_text(file, words - 10, SAMPLE_TOP + 248, SVG_LEFT, "", "the boundary belongs");
    svg_text(file, words - 10, SAMPLE_TOP + 276, SVG_LEFT, "", "to the circle");
    svg_text(file, SAMPLE_LEFT, SAMPLE_TOP + (SAMPLE_ROWS - 1) * PIXEL + 50, SVG_LEFT, "",
             "x counts to the right, y downwards; row 0 is the top row");
    svg_end(file);
}
