// 05-half-chord.svg, 05-hits.svg: a ray and a sphere.
#include "figures3d.h"

#include "oracle3d.h"

#include <math.h>

// ---- The triangle -------------------------------------------------------------------------------

// Along the ray and across it, in scene units and pixels.
enum { EYE_X = 60, RAY_Y = 200, UNIT = 340, CHORD_HEIGHT = 470 };

static double along(double t)
{
    return EYE_X + t * UNIT;
}

static void labels_draw(FILE *file, double b, double l, double half)
{
    svg_text(file, along(b * 0.42), RAY_Y - 14, SVG_MIDDLE, "", "b = c · d = %.4g", b);
    svg_text(file, along(b * 0.42), RAY_Y + l * UNIT * 0.42 + 34, SVG_MIDDLE, "", "c");
    svg_text(file, along(b) + 10, RAY_Y + l * UNIT * 0.55, SVG_LEFT, "", "l");
    svg_text(file, along(b - half / 2), RAY_Y - 46, SVG_MIDDLE, "", "half the chord");
    svg_line(file, along(b - half / 2), RAY_Y - 40, along(b - half / 2), RAY_Y - 6,
             "stroke=\"" SVG_GREY "\"");
    svg_text(file, along(b - half) - 16, RAY_Y - 14, SVG_RIGHT, "", "t = %.4g", b - half);
    svg_text(file, along(b + half) + 16, RAY_Y - 14, SVG_LEFT, "", "t = %.4g", b + half);
    svg_text(file, EYE_X - 20, RAY_Y + 36, SVG_LEFT, "", "eye");
    svg_text(file, 24, CHORD_HEIGHT - 106, SVG_LEFT, "", "c: from the eye to the centre");
    svg_text(file, 24, CHORD_HEIGHT - 76, SVG_LEFT, "", "d: the ray's direction, a unit vector");
    svg_text(file, 24, CHORD_HEIGHT - 46, SVG_LEFT, "", "l = c − b d, here %.4g long", l);
    svg_text(file, 24, CHORD_HEIGHT - 16, SVG_LEFT, "", "half² = r² − l · l = %.4g, half %.4g",
             half * half, half);
}

void draw_half_chord(FILE *file, const Followed *followed)
{
    const Steps *own = &followed->own;
    const Step *end = followed_step(own, steps_kept(own->n_steps) - 1);
    const Sphere sphere = followed->world->kind->data(followed->world).spheres[end->id];
    const OracleRay ray =
        oracle3d_given_ray((Vec3){own->origin[0], own->origin[1], own->origin[2]},
                           (Vec3){own->direction[0], own->direction[1], own->direction[2]}, 0);
    const OracleChord chord = oracle3d_chord(sphere, &ray, ORACLE_PROJECTION);
    const double b = chord.middle, half = chord.half;
    const double l = sqrt((double)sphere.radius * sphere.radius - half * half);
    const double centre_y = RAY_Y + l * UNIT;

    svg_begin(
        file, CHORD_HEIGHT, "The triangle of c, b, l, and half the chord",
        "A ray goes from the eye to the right through a sphere. From the eye c leads to the "
        "centre, "
        "and b along the ray to the point nearest to the centre; l lies between that point and the "
        "centre, at right angles to the ray. From that point half the chord leads back to where "
        "the "
        "ray enters, and on to where it leaves. Radius, l and half the chord are a right-angled "
        "triangle.");
    svg_title(file, 24, 40, SVG_LEFT, "",
              "Two right-angled triangles: c, b, l and r, l, half the chord");
    svg_circle(file, along(b), centre_y, sphere.radius * UNIT,
               "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLUE "\" stroke-width=\"3\"");
    svg_arrow(file, EYE_X, RAY_Y, 1000, RAY_Y, "stroke-width=\"2\"");
    svg_arrow(file, EYE_X, RAY_Y, along(b), centre_y,
              "stroke-width=\"2\" stroke-dasharray=\"8 5\"");
    svg_line(file, along(b - half), RAY_Y, along(b), RAY_Y,
             "stroke=\"" SVG_ORANGE "\" stroke-width=\"7\"");
    svg_line(file, along(b), RAY_Y, along(b), centre_y,
             "stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
    svg_line(file, along(b), centre_y, along(b - half), RAY_Y,
             "stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    svg_text(file, along(b - half / 2) - 12, centre_y - 22, SVG_RIGHT, SVG_HALO, "r");
    svg_box(file, along(b) - 14, RAY_Y, 14, 14, "fill=\"none\" stroke=\"" SVG_BLACK "\"");
    svg_circle(file, along(b), centre_y, 6, "fill=\"" SVG_BLACK "\"");
    for (int side = -1; side <= 1; side += 2) {
        svg_circle(file, along(b + side * half), RAY_Y, 8, "fill=\"" SVG_BLACK "\"");
    }
    svg_circle(file, EYE_X, RAY_Y, 9,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    labels_draw(file, b, l, half);
    svg_end(file);
}

// ---- How many hits ------------------------------------------------------------------------------

enum { PANELS = 4, PANEL = 232, PANEL_GAP = 22, TOP = 96, PANEL_HEIGHT = 240, RADIUS = 76 };

// The eye's place seen from the sphere's centre, along the ray and across it, in radii.
static const struct HitCase {
    const char *name;
    double eye_x, eye_y;
} HIT_CASES[PANELS] = {
    {"0: it misses", -1.4, 1.3},
    {"1: it touches", -1.4, 1},
    {"2: it goes through", -1.4, 0.5},
    {"the eye is inside", -0.35, 0.5},
};

static void panel_draw(FILE *file, int which)
{
    static const OracleRules3D RIGHT = {0};
    const struct HitCase *hit_case = &HIT_CASES[which];
    const double left = 16 + which * (PANEL + PANEL_GAP), middle = left + PANEL / 2.0 + 8;
    const double centre_y = TOP + PANEL_HEIGHT / 2.0, ray_y = centre_y - hit_case->eye_y * RADIUS;
    const Sphere sphere = {.radius = 1};
    const OracleRay ray = oracle3d_given_ray((Vec3){(f32)hit_case->eye_x, (f32)hit_case->eye_y, 0},
                                             (Vec3){1, 0, 0}, 0);
    const OracleChord chord = oracle3d_chord(sphere, &ray, ORACLE_PROJECTION);
    const OracleRoot root = oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &RIGHT);
    const double eye_x = middle + hit_case->eye_x * RADIUS;

    svg_text(file, left, TOP - 14, SVG_LEFT, "font-weight=\"bold\"", "%s", hit_case->name);
    svg_circle(file, middle, centre_y, RADIUS,
               "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLUE "\" stroke-width=\"3\"");
    svg_line(file, left, ray_y, eye_x, ray_y, "stroke=\"" SVG_GREY "\" stroke-dasharray=\"4 4\"");
    svg_arrow(file, eye_x, ray_y, left + PANEL, ray_y, "stroke-width=\"2\"");
    svg_circle(file, eye_x, ray_y, 8,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    const double y = TOP + PANEL_HEIGHT;
    if (isnan(chord.half)) {
        svg_text(file, left, y, SVG_LEFT, "", "disc < 0");
        svg_text(file, left, y + 28, SVG_LEFT, "", "no hit");
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        const double t = chord.middle + side * chord.half;
        svg_circle(file, eye_x + t * RADIUS, ray_y, 8,
                   t == root.t ? "fill=\"" SVG_BLACK "\""
                               : "fill=\"#ffffff\" fill-opacity=\"0\" stroke=\"" SVG_BLACK
                                 "\" stroke-width=\"2\"");
    }
    svg_text(file, left, y, SVG_LEFT, "", "t_near %.3g", chord.middle - chord.half);
    svg_text(file, left, y + 28, SVG_LEFT, "", "t_far %.3g", chord.middle + chord.half);
    svg_text(file, left, y + 56, SVG_LEFT, "font-weight=\"bold\"", "hit at %.3g", root.t);
}

void draw_hits(FILE *file, const Followed *followed)
{
    (void)followed;
    svg_begin(
        file, TOP + PANEL_HEIGHT + 100, "No hit, one, two, and the eye inside",
        "Four rays to the right and a sphere of radius 1. The first misses it: no hit. The second "
        "touches it: both roots are one. The third goes through: of two roots the nearer is the "
        "hit. "
        "In the fourth the eye is inside: the nearer root is behind it, so the farther is the "
        "hit.");
    svg_title(file, 16, 40, SVG_LEFT, "",
              "The hit, in black, is the nearest root that is ahead of the eye");
    for (int which = 0; which < PANELS; which++) {
        panel_draw(file, which);
    }
    svg_text(file, 16, TOP + PANEL_HEIGHT + 88, SVG_LEFT, "fill=\"" SVG_GREY "\"",
             "A radius is 1; t counts from the eye, the white circle.");
    svg_end(file);
}
