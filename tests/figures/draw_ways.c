// 10-light.svg: a light is an eye, too. What a tile's rays hit lies close together, so the ways
// from a light to these points are a tile of rays once more.
#include "figures3d.h"

#include "complain.h"
#include "oracle3d_mirrors.h"

#include <math.h>

// Scene units and pixels. All is in the plane z = 0.
enum { UNIT = 118, LEFT = 40, TOP = 84, HEIGHT = 640 };
static const double FIRST_X = -4.1, LAST_Y = 4.0;

enum { LIT, BLOCKER, N_BALLS };
static const Sphere BALLS[N_BALLS] = {{1.2f, -1.6f, 0, 2.4f}, {0.62f, 2.1f, 0, 0.22f}};
static const OracleVector EYE = {-3.6, 2.3, 0}, LIGHT = {1.2, 3.6, 0};
// The first and the last ray go through these points; the others between them.
static const OracleVector FIRST = {-0.5, 0.08, 0}, LAST = {0.9, 0.79, 0};
enum { N_RAYS = 8 };

static const OracleRules3D RIGHT = {0};

static double x_of(OracleVector p)
{
    return LEFT + (p.x - FIRST_X) * UNIT;
}

static double y_of(OracleVector p)
{
    return TOP + (LAST_Y - p.y) * UNIT;
}

static OracleVector on_way(OracleVector from, OracleVector direction, double t)
{
    return vector_plus(from, vector_scaled(t, direction));
}

static void way_draw(FILE *file, OracleVector from, OracleVector to, const char *look)
{
    svg_line(file, x_of(from), y_of(from), x_of(to), y_of(to), look);
}

// What ray i of the tile hits: a point of the lit ball.
static OracleVector point_hit(int i)
{
    const double share = i / (N_RAYS - 1.0);
    const OracleVector at = vector_plus(FIRST, vector_scaled(share, vector_minus(LAST, FIRST)));
    const OracleRay ray = {.origin = EYE, .direction = vector_unit(vector_minus(at, EYE))};
    const OracleHit hit = oracle3d_nearest(BALLS, N_BALLS, &ray, &RIGHT);
    if (hit.sphere != LIT) {
        complain("figures3d: ray %d hits sphere %u, expected %d", i, hit.sphere, LIT);
        exit(EXIT_FAILURE);
    }
    return on_way(EYE, ray.direction, hit.t);
}

// The cone around the rays from a place to points, as far as `length`.
static void cone_draw(FILE *file, OracleVector from, const OracleVector *points, double length,
                      const char *look)
{
    const OracleVector first = vector_unit(vector_minus(points[0], from));
    const OracleVector last = vector_unit(vector_minus(points[N_RAYS - 1], from));
    const OracleVector a = on_way(from, first, length), b = on_way(from, last, length);
    fprintf(file, "<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\" %s/>\n", x_of(from),
            y_of(from), x_of(a), y_of(a), x_of(b), y_of(b), look);
}

// The way from the light to a point: open, or closed by the ball that stands in it. Returns whether
// it is open.
static int way_from_light(FILE *file, OracleVector point)
{
    const OracleVector back = vector_minus(LIGHT, point);
    const OracleRay ray = {.origin = point, .direction = vector_unit(back), .leaves = &BALLS[LIT]};
    const OracleHit hit = oracle3d_nearest(BALLS, N_BALLS, &ray, &RIGHT);
    if (hit.t < vector_length(back)) {
        const OracleVector stop = on_way(point, ray.direction, hit.t);
        way_draw(file, LIGHT, point,
                 "stroke=\"" SVG_GREY "\" stroke-width=\"2\" stroke-dasharray=\"4 6\"");
        svg_cross(file, x_of(stop), y_of(stop), 7, "stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
        return 0;
    }
    way_draw(file, LIGHT, point, "stroke=\"" SVG_ORANGE "\" stroke-width=\"3\"");
    return 1;
}

static void place_draw(FILE *file, OracleVector at, const char *fill, const char *name, double dy)
{
    svg_circle(file, x_of(at), y_of(at), 11, fill);
    svg_text(file, x_of(at), y_of(at) + dy, SVG_MIDDLE, SVG_HALO, "%s", name);
}

void draw_ways(FILE *file, const Followed *followed)
{
    (void)followed;
    OracleVector points[N_RAYS];
    for (int i = 0; i < N_RAYS; i++) {
        points[i] = point_hit(i);
    }
    svg_begin(file, HEIGHT, "A light is an eye, too",
              "From the eye eight rays of a tile hit a ball at points that are close together. "
              "From a light a cone goes to these points: one search finds the spheres that stand "
              "in the ways. A small ball blocks some of them, the others are open.");
    svg_title(file, 24, 40, SVG_LEFT, "",
              "From a light to what a tile has hit: a tile of rays once more");
    cone_draw(file, LIGHT, points, vector_length(vector_minus(points[0], LIGHT)),
              "fill=\"" SVG_SAND "\"");
    cone_draw(file, EYE, points, vector_length(vector_minus(points[0], EYE)),
              "fill=\"" SVG_SKY "\"");
    for (int i = 0; i < N_BALLS; i++) {
        const OracleVector centre = {BALLS[i].x, BALLS[i].y, 0};
        svg_circle(file, x_of(centre), y_of(centre), BALLS[i].radius * UNIT,
                   "fill=\"" SVG_PALE "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    }
    int n_open = 0;
    for (int i = 0; i < N_RAYS; i++) {
        way_draw(file, EYE, points[i], "stroke=\"" SVG_BLUE "\" stroke-width=\"2\"");
        n_open += way_from_light(file, points[i]);
        svg_circle(file, x_of(points[i]), y_of(points[i]), 6, "fill=\"" SVG_BLACK "\"");
    }
    place_draw(file, EYE, "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"", "the eye",
               38);
    place_draw(file, LIGHT, "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"",
               "a light", -22);
    svg_text(file, 24, HEIGHT - 82, SVG_LEFT, "", "blue: %d rays from the eye", N_RAYS);
    svg_text(file, 24, HEIGHT - 52, SVG_LEFT, "", "orange: %d open ways from the light", n_open);
    svg_text(file, 24, HEIGHT - 22, SVG_LEFT, "", "dashed: %d ways closed by a ball",
             N_RAYS - n_open);
    svg_end(file);
}
