// 08-cost.svg: what a split costs, over its position: lab 08's example, by lab 08's functions. The
// notes show the middle; in a browser a reader moves the plane (slides-notes/touch).
#include "figures3d.h"

#include "complain.h"
#include "kdtree3d_sah.h"

#include <math.h>

// Scene units and pixels: the cell from the side, and the curve below it.
// Narrow, on a phone, its letters are larger.
enum { NARROW_TEXT = 30 };
enum { LEFT = 104, UNIT = 28, CELL_TOP = 72, CURVE_TOP = 340, CURVE_HEIGHT = 180, HEIGHT = 590 };
static const double MOST_COST = 6;

static const BBox3D CELL = {{0, 0, 0}, {32, 8, 8}};

// Two heaps: six with ranges within [1, 8], the last of which ends at 8, four within [24, 30].
static const Sphere HEAPS[] = {
    {2.5f, 2.6f, 4, 1.5f},   {3, 5.4f, 4, 1.75f},   {4.5f, 4, 4, 1.25f}, {5.25f, 2.5f, 4, 1.75f},
    {6, 5.7f, 4, 1.75f},     {6.5f, 3.7f, 4, 1.5f}, {25.5f, 3, 4, 1.5f}, {26.25f, 5.5f, 4, 1.75f},
    {27.75f, 2.8f, 4, 1.5f}, {28.5f, 5, 4, 1.5f},
};
enum { N_SPHERES = sizeof HEAPS / sizeof *HEAPS };

// A candidate plane of x: how many spheres each child would have, and what it costs.
typedef struct Candidate {
    f32 pos;
    u32 n_lower, n_higher;
    double cost;
} Candidate;

static Candidate candidate(int number)
{
    Candidate plane = {.pos = candidate_plane(CELL, 0, number)};
    for (int i = 0; i < N_SPHERES; i++) {
        plane.n_lower += HEAPS[i].x - HEAPS[i].radius <= plane.pos;
        plane.n_higher += HEAPS[i].x + HEAPS[i].radius >= plane.pos;
    }
    plane.cost = split_cost(CELL, (KdSplit){0, plane.pos}, plane.n_lower, plane.n_higher);
    return plane;
}

static double x_of(double x)
{
    return LEFT + x * UNIT;
}

static double cost_y(double cost)
{
    return CURVE_TOP + CURVE_HEIGHT * (1 - cost / MOST_COST);
}

static void cell_draw(FILE *file, f32 best, f32 chosen)
{
    const double height = (CELL.max[1] - CELL.min[1]) * UNIT;
    svg_box(file, x_of(0), CELL_TOP, x_of(CELL.max[0]) - x_of(0), height,
            "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    for (int i = 1; i < N_BINS; i++) {
        const double x = x_of(candidate_plane(CELL, 0, i));
        svg_line(file, x, CELL_TOP, x, CELL_TOP + height, "stroke=\"#b0b0b0\"");
    }
    for (int i = 0; i < N_SPHERES; i++) {
        svg_circle(file, x_of(HEAPS[i].x), CELL_TOP + HEAPS[i].y * UNIT, HEAPS[i].radius * UNIT,
                   "fill=\"" SVG_SKY "\" fill-opacity=\"0.8\" stroke=\"" SVG_BLUE
                   "\" stroke-width=\"2\"");
    }
    // Down to the curve.
    svg_line(file, x_of(chosen), CELL_TOP - 10, x_of(chosen), cost_y(0),
             "stroke=\"" SVG_BLACK "\" stroke-width=\"3\" stroke-dasharray=\"10 5\"");
    svg_line(file, x_of(best), CELL_TOP - 10, x_of(best), cost_y(0),
             "stroke=\"" SVG_ORANGE "\" stroke-width=\"4\"");
}

static void axes_draw(FILE *file)
{
    for (int cost = 0; cost <= MOST_COST; cost++) {
        svg_line(file, x_of(0), cost_y(cost), x_of(32), cost_y(cost), "stroke=\"#d0d0d0\"");
        svg_text(file, LEFT - 12, cost_y(cost) + 7, SVG_RIGHT, "", "%d", cost);
    }
    svg_line(file, x_of(0), cost_y(0), x_of(32), cost_y(0),
             "stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    for (int x = 0; x <= 32; x += 8) {
        svg_text(file, x_of(x), cost_y(0) + 28, SVG_MIDDLE, "", "%d", x);
    }
    svg_text(file, x_of(16), cost_y(0) + 58, SVG_MIDDLE, "",
             "the plane's position on x: %d candidates, %d bins", N_BINS - 1, N_BINS);
    svg_text(file, x_of(32), CURVE_TOP - 22, SVG_RIGHT, "",
             "expected cost of a ray that meets the cell");
}

static void curve_draw(FILE *file)
{
    fputs("<polyline fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\" points=\"", file);
    for (int i = 1; i < N_BINS; i++) {
        const Candidate plane = candidate(i);
        fprintf(file, "%.1f,%.1f ", x_of(plane.pos), cost_y(plane.cost));
    }
    fputs("\"/>\n", file);
    for (int i = 1; i < N_BINS; i++) {
        const Candidate plane = candidate(i);
        svg_circle(file, x_of(plane.pos), cost_y(plane.cost), 5, "fill=\"" SVG_BLACK "\"");
    }
}

// A point of the curve, and below the curve, where there is room, what it stands for.
static void mark(FILE *file, int number, int row, const char *look, const char *name,
                 FigureShape shape)
{
    const Candidate plane = candidate(number);
    const double y = cost_y(2.3 - 1.2 * row);
    svg_circle(file, x_of(plane.pos), cost_y(plane.cost), 10, look);
    svg_circle(file, x_of(11), y - 7, 10, look);
    if (shape == SHAPE_NARROW) {
        svg_text(file, x_of(11.7), y, SVG_LEFT, SVG_HALO, "%s: %.3g", name, plane.cost);
    } else {
        svg_text(file, x_of(11.7), y, SVG_LEFT, SVG_HALO, "%s: %.3g, at x = %g, %u below, %u above",
                 name, plane.cost, plane.pos, plane.n_lower, plane.n_higher);
    }
}

static int cheapest_plane(void)
{
    int cheapest = 1;
    for (int i = 2; i < N_BINS; i++) {
        cheapest = candidate(i).cost < candidate(cheapest).cost ? i : cheapest;
    }
    return cheapest;
}

// ---- Moving the plane ---------------------------------------------------------------------------

int cost_plane_at(double x)
{
    const double n = round((x - LEFT) / UNIT / (CELL.max[0] - CELL.min[0]) * N_BINS);
    return (int)fmin(fmax(n, 1), N_BINS - 1);
}

void cost_plane_tell(FILE *file, int number)
{
    const Candidate plane = candidate(number), cheapest = candidate(cheapest_plane());
    fprintf(file, "Plane %d of %d: x = %g, cost %.4g\n", number, N_BINS - 1, plane.pos, plane.cost);
    fprintf(file, "spheres in the lower child: %u, in the higher: %u\n", plane.n_lower,
            plane.n_higher);
    fprintf(file, "the cheapest: x = %g, cost %.4g; a leaf: %g", cheapest.pos, cheapest.cost,
            KD_COST_TEST * N_SPHERES);
}

void draw_cost_plane(FILE *file, int number, FigureShape shape)
{
    const int cheapest = cheapest_plane();
    svg_begin(file, HEIGHT, "The cost of a split over its position",
              "Above: a long cell with six spheres at its left end and four at its right, and the "
              "31 candidate planes between its 32 bins. Below: the cost of each plane. It falls "
              "to 3.58 just behind the six spheres, rises slowly up to the four and steeply into "
              "them. A leaf would cost 5, so the node is split.");
    if (shape == SHAPE_NARROW) {
        fprintf(file, "<g font-size=\"%d\">\n", NARROW_TEXT);
    }
    svg_title(file, 24, 40, SVG_LEFT, "", "The cheapest plane leaves the empty room to the few");
    axes_draw(file);
    cell_draw(file, candidate(cheapest).pos, candidate(number).pos);
    const double leaf = KD_COST_TEST * N_SPHERES;
    svg_line(file, x_of(0), cost_y(leaf), x_of(32), cost_y(leaf),
             "stroke=\"" SVG_BLUE "\" stroke-width=\"3\" stroke-dasharray=\"10 6\"");
    svg_text(file, x_of(10), cost_y(leaf) - 8, SVG_LEFT, SVG_HALO,
             "a leaf: %g, all %d spheres tested", leaf, N_SPHERES);
    curve_draw(file);
    mark(file, cheapest, 0, "fill=\"" SVG_ORANGE "\" stroke=\"" SVG_BLACK "\"", "the cheapest",
         shape);
    mark(file, number, 1, "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"",
         number == N_BINS / 2 ? "the middle" : "this plane", shape);
    if (shape == SHAPE_NARROW) {
        fputs("</g>\n", file);
    }
    // Where a reader takes hold of the plane (slides-notes/touch/touch.js).
    svg_box(file, x_of(0), CELL_TOP, x_of(CELL.max[0]) - x_of(0), cost_y(0) - CELL_TOP,
            "class=\"drag\" fill=\"none\" pointer-events=\"all\"");
    svg_end(file);
}

void draw_cost(FILE *file, const Followed *followed)
{
    (void)followed;
    u32 ids[N_SPHERES];
    for (u32 i = 0; i < N_SPHERES; i++) {
        ids[i] = i;
    }
    const BestSplit best = find_best_split(HEAPS, ids, N_SPHERES, CELL);
    const f32 cheapest = candidate(cheapest_plane()).pos;
    if (best.split.axis != 0 || best.split.pos != cheapest) {
        complain("figures3d: the curve's lowest plane is at %g, find_best_split() found %g",
                 cheapest, best.split.pos);
        exit(EXIT_FAILURE);
    }
    draw_cost_plane(file, N_BINS / 2, SHAPE_STILL);
}
