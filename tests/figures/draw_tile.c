// 10-tile.svg: a tile's rays, the cone around them, and where they meet a plane: an interval.
#include "figures3d.h"

#include "oracle3d.h"

#include <math.h>

// From above, in scene units and pixels; and t below.
enum { UNIT = 76, LEFT = 60, EYE_Y = 340, T_TOP = 408, T_LEFT = 60, T_UNIT = 158, ROW = 37 };
enum { BAR = 30, HEIGHT = 590 };
// A row of a tile, of a picture that has no other pixels, and the plane that it meets.
enum { N_RAYS = 8 };
static const double FOV = 0.42, LOOK = 0.5, PLANE = 1.6;
// The node's part of the tile's rays.
static const double T_MIN = 1.5, T_MAX = 5.6;
// A sphere beside the cone, and one that some rays hit: along the cone's axis, beside it, radius.
static const double MISSED[] = {2.5, -1.06, 0.42}, MET[] = {3.7, -0.62, 0.3};

static const OracleRules3D RIGHT = {0};

// What holds for all rays.
typedef struct Row {
    OracleVector directions[N_RAYS];
    double t_low, t_high;  // where they meet the plane
    OracleVector axis;     // of the cone
    double angle;          // from it to the ray that is farthest off
} Row;

static double x_of(double x)
{
    return LEFT + x * UNIT;
}

static double y_of(double y)
{
    return EYE_Y - y * UNIT;
}

static Row row_of_rays(void)
{
    Row row = {.t_low = INFINITY};
    const OracleVector forward = {cos(LOOK), sin(LOOK), 0}, right = {sin(LOOK), -cos(LOOK), 0};
    OracleVector least = {INFINITY, INFINITY, 0}, most = {-INFINITY, -INFINITY, 0};
    for (int i = 0; i < N_RAYS; i++) {
        const double aside = oracle3d_display(i, 0, N_RAYS, 1, FOV, &RIGHT).x;
        const OracleVector d = vector_unit(vector_plus(forward, vector_scaled(aside, right)));
        row.directions[i] = d;
        row.t_low = fmin(row.t_low, PLANE / d.y);
        row.t_high = fmax(row.t_high, PLANE / d.y);
        least = (OracleVector){fmin(least.x, d.x), fmin(least.y, d.y), 0};
        most = (OracleVector){fmax(most.x, d.x), fmax(most.y, d.y), 0};
    }
    row.axis = vector_unit(vector_plus(least, most));
    for (int i = 0; i < N_RAYS; i++) {
        row.angle = fmax(row.angle, acos(vector_dot(row.axis, row.directions[i])));
    }
    return row;
}

// A point so far along a direction, turned by an angle.
static void line_from_eye(FILE *file, OracleVector d, double turn, double from, double to,
                          const char *look)
{
    const double x = d.x * cos(turn) - d.y * sin(turn), y = d.x * sin(turn) + d.y * cos(turn);
    svg_line(file, x_of(from * x), y_of(from * y), x_of(to * x), y_of(to * y), look);
}

static void cone_draw(FILE *file, const Row *row)
{
    fprintf(file, "<polygon fill=\"" SVG_SKY "\" points=\"%.1f,%.1f", x_of(0), y_of(0));
    for (int side = -1; side <= 1; side += 2) {
        const double turn = atan2(row->axis.y, row->axis.x) + side * row->angle;
        fprintf(file, " %.1f,%.1f", x_of(T_MAX * cos(turn)), y_of(T_MAX * sin(turn)));
    }
    fputs("\"/>\n", file);
    for (int i = 0; i < N_RAYS; i++) {
        line_from_eye(file, row->directions[i], 0, 0, T_MAX, "stroke=\"" SVG_GREY "\"");
    }
    for (int side = -1; side <= 1; side += 2) {
        line_from_eye(file, row->axis, side * row->angle, 0, T_MAX,
                      "stroke=\"" SVG_BLUE "\" stroke-width=\"4\"");
    }
    line_from_eye(file, row->axis, 0, 0, T_MAX,
                  "stroke=\"" SVG_BLUE "\" stroke-width=\"2\" stroke-dasharray=\"10 6\"");
}

static void sphere_draw(FILE *file, const Row *row, const double *sphere, const char *look,
                        const char *first, const char *second)
{
    const double x = sphere[0] * row->axis.x - sphere[1] * row->axis.y;
    const double y = sphere[0] * row->axis.y + sphere[1] * row->axis.x;
    svg_circle(file, x_of(x), y_of(y), sphere[2] * UNIT, look);
    svg_text(file, x_of(x + sphere[2]) + 12, y_of(y) + 20, SVG_LEFT, SVG_HALO, "%s", first);
    svg_text(file, x_of(x + sphere[2]) + 12, y_of(y) + 46, SVG_LEFT, SVG_HALO, "%s", second);
}

static void plane_draw(FILE *file, const Row *row)
{
    svg_line(file, x_of(0), y_of(PLANE), 1000, y_of(PLANE),
             "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
    svg_text(file, x_of(0), y_of(PLANE) - 14, SVG_LEFT, "", "a node's plane");
    for (int i = 0; i < N_RAYS; i++) {
        const double t = PLANE / row->directions[i].y;
        svg_circle(file, x_of(t * row->directions[i].x), y_of(PLANE), 6, "fill=\"" SVG_BLACK "\"");
    }
}

static void part_draw(FILE *file, int number, const char *name, double from, double to,
                      const char *look)
{
    const double y = T_TOP + number * ROW;
    svg_box(file, T_LEFT + from * T_UNIT, y, (to - from) * T_UNIT, BAR, look);
    svg_text(file, T_LEFT + from * T_UNIT + 10, y + 22, SVG_LEFT, "", "%s: t %.3g to %.3g", name,
             from, to);
}

void draw_tile(FILE *file, const Followed *followed)
{
    (void)followed;
    const Row row = row_of_rays();
    svg_begin(
        file, HEIGHT, "A tile: rays, cone, and an interval of distances to a plane",
        "Eight rays of a tile fan out from the eye inside a cone. They meet a node's plane at "
        "different distances, from the least to the greatest: an interval. The near child "
        "is searched up to the greatest, the far one from the least on, so their parts "
        "overlap. Of two spheres one stands beside the cone and is left out for all rays; "
        "the other is met by the cone and tested.");
    svg_title(file, 24, 40, SVG_LEFT, "",
              "What one ray knew as a number is an interval for a tile");
    cone_draw(file, &row);
    plane_draw(file, &row);
    sphere_draw(file, &row, MISSED, "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"",
                "beside the cone:", "tested for no ray");
    sphere_draw(file, &row, MET,
                "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"",
                "met by the cone:", "tested for all");
    svg_circle(file, x_of(0), y_of(0), 9,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    svg_text(file, x_of(0) - 12, y_of(0) + 34, SVG_LEFT, "", "eye");

    svg_text(file, T_LEFT, T_TOP + 10, SVG_LEFT, "fill=\"" SVG_GREY "\"", "t = 0");
    svg_line(file, T_LEFT, T_TOP - 14, 1000, T_TOP - 14, "stroke=\"" SVG_BLACK "\"");
    for (int i = 0; i < N_RAYS; i++) {
        svg_circle(file, T_LEFT + PLANE / row.directions[i].y * T_UNIT, T_TOP - 14, 6,
                   "fill=\"" SVG_BLACK "\"");
    }
    part_draw(file, 0, "the node", T_MIN, T_MAX, "fill=\"" SVG_PALE "\" stroke=\"" SVG_BLACK "\"");
    part_draw(file, 1, "t_split", row.t_low, row.t_high,
              "fill=\"#ffffff\" stroke=\"" SVG_ORANGE "\" stroke-width=\"4\"");
    part_draw(file, 2, "near child", T_MIN, row.t_high,
              "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    part_draw(file, 3, "far child, waits", row.t_low, T_MAX,
              "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-dasharray=\"6 4\" stroke-width=\"2\"");
    svg_text(file, T_LEFT, T_TOP + 4 * ROW + 28, SVG_LEFT, "fill=\"" SVG_GREY "\"",
             "Between %.3g and %.3g both children are searched: rays are on either side.",
             row.t_low, row.t_high);
    svg_end(file);
}
