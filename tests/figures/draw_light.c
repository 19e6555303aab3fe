// 09-rays.svg: from a hit a shadow ray goes to each light, and one ray on by the mirror's law.
#include "figures3d.h"

#include "complain.h"
#include "oracle3d_mirrors.h"

#include <math.h>

// Scene units and pixels. All stands in the plane z = 0.
enum { UNIT = 115, LEFT = 100, TOP = 64, HEIGHT = 590 };
static const double FIRST_X = -3.2, LAST_Y = 3.95;

enum { MIRROR, SEEN, BLOCKER, N_BALLS };
static const Sphere BALLS[N_BALLS] = {
    {0, 0, 0, 1}, {1.9f, 2.25f, 0, 0.55f}, {0.42f, 2.5f, 0, 0.33f}};
// Where the lights stand: one arrives, one is blocked, one is behind the surface.
enum { N_LIGHTS = 3 };
static const Vec3 LIGHTS[N_LIGHTS] = {{-1.9f, 3.5f, 0}, {0.86f, 3.6f, 0}, {3.6f, 0.2f, 0}};
static const Vec3 EYE = {-3, 1.9f, 0}, LOOKED_AT = {-0.1736f, 0.9848f, 0};

static const OracleRules3D RIGHT = {0};

static double x_of(OracleVector p)
{
    return LEFT + (p.x - FIRST_X) * UNIT;
}

static double y_of(OracleVector p)
{
    return TOP + (LAST_Y - p.y) * UNIT;
}

static OracleVector on_ray(OracleVector origin, OracleVector direction, double t)
{
    return vector_plus(origin, vector_scaled(t, direction));
}

static void way_draw(FILE *file, OracleVector from, OracleVector to, const char *look)
{
    svg_arrow(file, x_of(from), y_of(from), x_of(to), y_of(to), look);
}

static void ball_draw(FILE *file, int which, const char *look, const char *name, double dy)
{
    const OracleVector centre = {BALLS[which].x, BALLS[which].y, 0};
    svg_circle(file, x_of(centre), y_of(centre), BALLS[which].radius * UNIT, look);
    svg_text(file, x_of(centre), y_of(centre) + dy, SVG_MIDDLE, "", "%s", name);
}

// One light's way: the shadow ray up to it, or to what blocks it; none where it is behind.
static void light_draw(FILE *file, int which, OracleVector point, OracleVector normal)
{
    const OracleVector light = vector_of(LIGHTS[which]), way = vector_minus(light, point);
    const double x = x_of(light), y = y_of(light), distance = vector_length(way);
    OracleRay ray = {.origin = point, .direction = vector_unit(way), .leaves = &BALLS[MIRROR]};
    const OracleHit hit = oracle3d_nearest(BALLS, N_BALLS, &ray, &RIGHT);
    const char *end = "arrives";
    if (vector_dot(normal, way) <= 0) {
        end = "is behind the surface: no ray";
        svg_line(file, x_of(point), y_of(point), x, y,
                 "stroke=\"" SVG_GREY "\" stroke-width=\"1.5\" stroke-dasharray=\"2 7\"");
    } else if (hit.t < distance) {
        const OracleVector stop = on_ray(point, ray.direction, hit.t);
        end = "is blocked";
        way_draw(file, point, stop, "stroke-width=\"3\" stroke-dasharray=\"11 6\"");
        svg_line(file, x_of(stop), y_of(stop), x, y,
                 "stroke=\"" SVG_GREY "\" stroke-width=\"1.5\" stroke-dasharray=\"2 7\"");
        svg_cross(file, x_of(stop), y_of(stop), 9, "stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
    } else {
        way_draw(file, point, on_ray(point, ray.direction, distance - 0.14),
                 "stroke-width=\"3\" stroke-dasharray=\"11 6\"");
    }
    for (int i = 0; i < 4; i++) {
        const double dx = 20 * cos(i * M_PI / 4), dy = 20 * sin(i * M_PI / 4);
        svg_line(file, x - dx, y - dy, x + dx, y + dy, "stroke=\"" SVG_BLACK "\"");
    }
    svg_circle(file, x, y, 12, "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    svg_text(file, x + (which == 2 ? 120 : 0), y + (which == 2 ? 46 : -26),
             which == 2 ? SVG_RIGHT : SVG_MIDDLE, SVG_HALO, "light %d %s", which + 1, end);
}

// The angles of entry and exit to the normal, as arcs of one radius.
static void angle_draw(FILE *file, OracleVector point, OracleVector from, OracleVector to)
{
    const double radius = 0.5;
    const OracleVector a = on_ray(point, from, radius), b = on_ray(point, to, radius);
    fprintf(file,
            "<path d=\"M%.1f %.1fA%.1f %.1f 0 0 1 %.1f %.1f\" fill=\"none\" stroke=\"" SVG_BLACK
            "\" stroke-width=\"2\"/>\n",
            x_of(a), y_of(a), radius * UNIT, radius * UNIT, x_of(b), y_of(b));
}

void draw_light(FILE *file, const Followed *followed)
{
    (void)followed;
    const OracleVector eye = vector_of(EYE);
    const OracleVector direction = vector_unit(vector_minus(vector_of(LOOKED_AT), eye));
    const OracleRay ray = {.origin = eye, .direction = direction};
    const OracleHit hit = oracle3d_nearest(BALLS, N_BALLS, &ray, &RIGHT);
    if (hit.sphere != MIRROR) {
        complain("figures3d: the ray hits sphere %u, expected %d", hit.sphere, MIRROR);
        exit(EXIT_FAILURE);
    }
    const OracleVector point = on_ray(eye, direction, hit.t);
    const OracleNear normal =
        oracle3d_normal(BALLS[MIRROR], (OracleNear){point, 0}, (OracleNear){direction, 0}, &RIGHT);
    const OracleVector mirrored =
        oracle3d_mirrored((OracleNear){direction, 0}, normal, TURN_RIGHT).value;
    const OracleRay onward = {.origin = point, .direction = mirrored, .leaves = &BALLS[MIRROR]};
    const OracleHit next = oracle3d_nearest(BALLS, N_BALLS, &onward, &RIGHT);

    svg_begin(file, HEIGHT, "A hit's shadow rays and its mirrored ray",
              "From the eye a ray hits a mirror ball. From the hit dashed shadow rays go to "
              "lights: to light 1, which arrives, and to light 2, which another ball blocks. "
              "Light 3 is behind the surface and needs no ray. The mirrored ray leaves the "
              "surface at the angle at which the first one came and hits a third ball.");
    svg_title(file, 24, 40, SVG_LEFT, "", "At a hit: one shadow ray a light, and one mirrored ray");
    ball_draw(file, MIRROR, "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLUE "\" stroke-width=\"3\"",
              "a mirror", 10);
    ball_draw(file, SEEN, "fill=\"" SVG_PALE "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"",
              "seen in it", 8);
    ball_draw(file, BLOCKER, "fill=\"#9a9a9a\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"", "", 0);
    for (int i = 0; i < N_LIGHTS; i++) {
        light_draw(file, i, point, normal.value);
    }
    const OracleVector tip = on_ray(point, normal.value, 0.85);
    way_draw(file, point, tip, "stroke-width=\"2\"");
    svg_text(file, x_of(tip) - 16, y_of(tip) + 8, SVG_MIDDLE, SVG_HALO, "n");
    angle_draw(file, point, vector_scaled(-1, direction), normal.value);
    angle_draw(file, point, normal.value, mirrored);
    way_draw(file, eye, point, "stroke-width=\"4\"");
    way_draw(file, point, on_ray(point, mirrored, next.t), "stroke-width=\"4\"");
    const OracleVector half = on_ray(point, mirrored, next.t * 0.62);
    svg_text(file, x_of(half) + 12, y_of(half) + 26, SVG_LEFT, SVG_HALO, "d' = d − 2 (d · n) n");
    svg_text(file, x_of(eye) + 70, y_of(eye) - 4, SVG_LEFT, SVG_HALO, "d");
    svg_circle(file, x_of(eye), y_of(eye), 9,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    svg_text(file, x_of(eye), y_of(eye) + 34, SVG_MIDDLE, "", "eye");
    svg_circle(file, x_of(point), y_of(point), 7, "fill=\"" SVG_BLACK "\"");
    svg_text(file, 24, HEIGHT - 72, SVG_LEFT, SVG_HALO, "New rays start");
    svg_text(file, 24, HEIGHT - 44, SVG_LEFT, SVG_HALO, "2⁻¹⁸ (t + r + largest coordinate)");
    svg_text(file, 24, HEIGHT - 16, SVG_LEFT, SVG_HALO, "= %.6f above the surface",
             oracle3d_offset(point, hit.t, BALLS[MIRROR].radius));
    svg_end(file);
}
