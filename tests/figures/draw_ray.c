// 07-slabs.svg, 07-cases.svg, 07-stack.svg: a ray in the box, at a node, and through the tree.
#include "figures3d.h"

#include "complain.h"
#include "followed_svg.h"

#include <math.h>

void draw_stack(FILE *file, const Followed *followed)
{
    ray_svg(followed, file);
}

// ---- Slabs --------------------------------------------------------------------------------------

// The plane of x and y from above, in scene units and pixels; the axis of t below it.
static const double FIRST_X = -2.4, LAST_Y = 1.55, UNIT = 96;
enum { PLAN_LEFT = 60, PLAN_TOP = 72, PLAN_WIDTH = 384, PLAN_HEIGHT = 278 };
enum { T_LEFT = 210, T_UNIT = 190, T_TOP = PLAN_TOP + PLAN_HEIGHT + 60, BAR = 30, ROW = 40 };

static double plan_x(double x)
{
    return PLAN_LEFT + (x - FIRST_X) * UNIT;
}

static double plan_y(double y)
{
    return PLAN_TOP + (LAST_Y - y) * UNIT;
}

// Where the ray meets the two planes of an axis, the nearer one first.
static void slab_met(const Followed *followed, int axis, double met[2])
{
    const BBox3D box = followed->world->kind->data(followed->world).tree3d->bounds;
    const double o = followed->own.origin[axis], d = followed->own.direction[axis];
    met[0] = (box.min[axis] - o) / d;
    met[1] = (box.max[axis] - o) / d;
    if (met[0] > met[1]) {
        const double other = met[0];
        met[0] = met[1];
        met[1] = other;
    }
}

static void point_draw(FILE *file, const Followed *followed, double t, const char *label, double dx,
                       double dy)
{
    const double x = plan_x(followed->own.origin[0] + t * followed->own.direction[0]);
    const double y = plan_y(followed->own.origin[1] + t * followed->own.direction[1]);
    svg_circle(file, x, y, 6, "fill=\"" SVG_BLACK "\"");
    svg_text(file, x + dx, y + dy, SVG_MIDDLE, SVG_HALO, label, t);
}

static void plan_draw(FILE *file, const Followed *followed)
{
    const BBox3D box = followed->world->kind->data(followed->world).tree3d->bounds;
    svg_box(file, plan_x(box.min[0]), PLAN_TOP, (box.max[0] - box.min[0]) * UNIT, PLAN_HEIGHT,
            "fill=\"" SVG_SKY "\"");
    svg_box(file, PLAN_LEFT, plan_y(box.max[1]), PLAN_WIDTH, (box.max[1] - box.min[1]) * UNIT,
            "fill=\"" SVG_SAND "\" fill-opacity=\"0.7\"");
    for (int side = 0; side < 2; side++) {
        const double x = plan_x(side ? box.max[0] : box.min[0]);
        const double y = plan_y(side ? box.max[1] : box.min[1]);
        svg_line(file, x, PLAN_TOP, x, PLAN_TOP + PLAN_HEIGHT, "stroke=\"" SVG_GREY "\"");
        svg_line(file, PLAN_LEFT, y, PLAN_LEFT + PLAN_WIDTH, y, "stroke=\"" SVG_GREY "\"");
        svg_text(file, x, PLAN_TOP + PLAN_HEIGHT + 22, SVG_MIDDLE, "", "x = %g",
                 side ? box.max[0] : box.min[0]);
        svg_text(file, PLAN_LEFT + PLAN_WIDTH + 8, y + 6, SVG_LEFT, "", "y = %g",
                 side ? box.max[1] : box.min[1]);
    }
    svg_box(file, plan_x(box.min[0]), plan_y(box.max[1]), (box.max[0] - box.min[0]) * UNIT,
            (box.max[1] - box.min[1]) * UNIT,
            "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
}

static void plan_ray_draw(FILE *file, const Followed *followed, const double x_met[2],
                          const double y_met[2])
{
    const f32 *o = followed->own.origin, *d = followed->own.direction;
    const double end = x_met[1] + 0.25;
    svg_arrow(file, plan_x(o[0]), plan_y(o[1]), plan_x(o[0] + end * d[0]),
              plan_y(o[1] + end * d[1]), "stroke-width=\"3\"");
    svg_circle(file, plan_x(o[0]), plan_y(o[1]), 9,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    svg_text(file, plan_x(o[0]), plan_y(o[1]) + 32, SVG_MIDDLE, SVG_HALO, "eye");
    point_draw(file, followed, x_met[0], "%.4g", -34, -6);
    point_draw(file, followed, x_met[1], "%.4g", 36, 20);
    point_draw(file, followed, y_met[0], "%.4g", 38, 20);
    point_draw(file, followed, y_met[1], "%.4g", -38, -10);
}

static void interval_draw(FILE *file, int row, const char *name, double from, double to,
                          const char *look)
{
    const double y = T_TOP + row * ROW;
    svg_text(file, T_LEFT - 20, y + 22, SVG_RIGHT, "", "%s", name);
    svg_box(file, T_LEFT + from * T_UNIT, y, (to - from) * T_UNIT, BAR, look);
    svg_text(file, T_LEFT + from * T_UNIT + 8, y + 22, SVG_LEFT, "", "%.4g", from);
    svg_text(file, T_LEFT + to * T_UNIT - 8, y + 22, SVG_RIGHT, "", "%.4g", to);
}

void draw_slabs(FILE *file, const Followed *followed)
{
    double x_met[2], y_met[2];
    slab_met(followed, 0, x_met);
    slab_met(followed, 1, y_met);
    const Step *first = followed_step(&followed->own, 0);
    svg_begin(file, T_TOP + 4 * ROW + 16, "Entry and exit: the box is where all slabs overlap",
              "From above: the box is where an upright and a level band cross. The ray from the "
              "eye meets "
              "the planes of y at t 0.333 and 3.333, those of x at 1.5 and 3.75. Below, along t: "
              "it is in "
              "both bands from 1.5, the last entry, to 3.333, the first exit.");
    svg_title(file, 24, 40, SVG_LEFT, "", "Inside from the last entry to the first exit");
    plan_draw(file, followed);
    plan_ray_draw(file, followed, x_met, y_met);
    const double words = PLAN_LEFT + PLAN_WIDTH + 100;
    svg_text(file, words, PLAN_TOP + 30, SVG_LEFT, "", "seen from above:");
    svg_text(file, words, PLAN_TOP + 60, SVG_LEFT, "", "the ray is level,");
    svg_text(file, words, PLAN_TOP + 90, SVG_LEFT, "", "between the planes");
    svg_text(file, words, PLAN_TOP + 120, SVG_LEFT, "", "of z all the way");
    interval_draw(file, 0, "t in slab y", y_met[0], y_met[1],
                  "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\"");
    interval_draw(file, 1, "t in slab x", x_met[0], x_met[1],
                  "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLACK "\"");
    // What the kernel began with.
    interval_draw(file, 2, "in the box", first->t_min, first->t_max,
                  "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
    svg_arrow(file, T_LEFT, T_TOP + 3 * ROW + 10, 1000, T_TOP + 3 * ROW + 10, "stroke-width=\"2\"");
    svg_text(file, T_LEFT - 20, T_TOP + 3 * ROW + 16, SVG_RIGHT, "", "t = 0");
    svg_end(file);
}

// ---- The cases at a node ------------------------------------------------------------------------

enum { CASES = 4, PANEL = 226, PANEL_GAP = 28, CASES_TOP = 120, PANEL_HEIGHT = 280 };

typedef struct Case {
    const char *name, *rule, *next;
} Case;

static const Case CASE_WORDS[CASES] = {
    {"behind the eye", "t_split ≤ 0", "go to near"},
    {"before the part", "0 < t_split < t_min", "go to far"},
    {"in the part", "t_min ≤ t_split ≤ t_max", "near; far waits"},
    {"beyond the part", "t_split > t_max", "go to near"},
};

// Where the ray meets a node's plane.
static double split_of(const Followed *followed, const Step *step)
{
    const KdNode3 node = followed->world->kind->data(followed->world).tree3d->nodes[step->id];
    return ((double)node.split_pos - followed->own.origin[node.split_axis]) /
           followed->own.direction[node.split_axis];
}

static int case_of(const Followed *followed, const Step *step)
{
    const double t_split = split_of(followed, step);
    return t_split <= 0 ? 0 : t_split < step->t_min ? 1 : t_split <= step->t_max ? 2 : 3;
}

// How well a panel would show it: how much of it the node's part of the ray would fill, or, where
// that is less, how much would lie between the part and the plane beside it.
static double clearness(const Followed *followed, const Step *step)
{
    const double t_split = split_of(followed, step), whole = fmax(step->t_max, fabs(t_split));
    const double part = step->t_max - step->t_min;
    const double between = t_split < step->t_min ? step->t_min - t_split : t_split - step->t_max;
    return (between > 0 ? fmin(part, between) : part) / whole;
}

// The inner node of this case on the recorded ray whose part is seen best.
static const Step *case_find(const Followed *followed, int wanted)
{
    const Step *best = NULL;
    for (u32 i = 0; i < steps_kept(followed->own.n_steps); i++) {
        const Step *step = &followed->own.steps[i];
        if (step->kind == STEP_NODE && case_of(followed, step) == wanted &&
            (best == NULL || clearness(followed, step) > clearness(followed, best))) {
            best = step;
        }
    }
    if (best == NULL) {
        complain("figures3d: no step of the ray is of case %d", wanted);
        exit(EXIT_FAILURE);
    }
    return best;
}

// A panel: to the right goes the coordinate along the split axis, upwards t.
typedef struct Panel {
    double left, bottom;
    double origin, direction;  // of the ray, along the split axis
    double t_low, t_high;      // the part of the ray that is shown: eye, part and plane are in it
    double low;                // the coordinate at the panel's left side
    double scale, rise;        // pixels a unit of the coordinate, and of t
} Panel;

static Panel panel_of(const Followed *followed, const Step *step, KdNode3 node, int which)
{
    const double o = followed->own.origin[node.split_axis];
    const double d = followed->own.direction[node.split_axis], t_split = split_of(followed, step);
    const double t_low = fmin(0, t_split) * 1.1, t_high = fmax(step->t_max, t_split) * 1.1;
    return (Panel){
        .left = 16 + which * (PANEL + PANEL_GAP),
        .bottom = CASES_TOP + PANEL_HEIGHT,
        .origin = o,
        .direction = d,
        .t_low = t_low,
        .t_high = t_high,
        .low = fmin(o + t_low * d, o + t_high * d),
        .scale = (PANEL - 40) / fabs((t_high - t_low) * d),
        .rise = (PANEL_HEIGHT - 60) / (t_high - t_low),
    };
}

static double panel_x(const Panel *panel, double coordinate)
{
    return panel->left + 20 + (coordinate - panel->low) * panel->scale;
}

static double ray_x(const Panel *panel, double t)
{
    return panel_x(panel, panel->origin + t * panel->direction);
}

static double ray_y(const Panel *panel, double t)
{
    return panel->bottom - 36 - (t - panel->t_low) * panel->rise;
}

static void panel_line(FILE *file, const Panel *panel, double from, double to, const char *look)
{
    svg_line(file, ray_x(panel, from), ray_y(panel, from), ray_x(panel, to), ray_y(panel, to),
             look);
}

// The two sides of the plane, and the plane.
static void sides_draw(FILE *file, const Panel *panel, double split_pos)
{
    const double plane_x = panel_x(panel, split_pos), right = panel->left + PANEL;
    const int is_near_left = panel->origin < split_pos;
    svg_box(file, is_near_left ? panel->left : plane_x, CASES_TOP,
            is_near_left ? plane_x - panel->left : right - plane_x, PANEL_HEIGHT,
            "fill=\"" SVG_SKY "\"");
    svg_box(file, panel->left, CASES_TOP, PANEL, PANEL_HEIGHT,
            "fill=\"none\" stroke=\"" SVG_GREY "\"");
    svg_line(file, plane_x, CASES_TOP, plane_x, panel->bottom,
             "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
}

static void panel_ray_draw(FILE *file, const Panel *panel, const Step *step, double t_split)
{
    panel_line(file, panel, panel->t_low, 0, "stroke=\"" SVG_BLACK "\" stroke-dasharray=\"4 4\"");
    svg_arrow(file, ray_x(panel, 0), ray_y(panel, 0), ray_x(panel, panel->t_high),
              ray_y(panel, panel->t_high), "stroke-width=\"1.5\"");
    panel_line(file, panel, step->t_min, step->t_max,
               "stroke=\"" SVG_BLACK "\" stroke-width=\"8\"");
    svg_circle(file, ray_x(panel, 0), ray_y(panel, 0), 8,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    svg_circle(file, ray_x(panel, t_split), ray_y(panel, t_split), 6,
               "fill=\"" SVG_ORANGE "\" stroke=\"" SVG_BLACK "\"");
}

static void case_draw(FILE *file, const Followed *followed, int which)
{
    const Step *step = case_find(followed, which);
    const KdNode3 node = followed->world->kind->data(followed->world).tree3d->nodes[step->id];
    const double t_split = split_of(followed, step);
    const Panel panel = panel_of(followed, step, node, which);
    const Case *words = &CASE_WORDS[which];
    sides_draw(file, &panel, node.split_pos);
    panel_ray_draw(file, &panel, step, t_split);

    const double left = panel.left, below = panel.bottom;
    svg_text(file, left, CASES_TOP - 40, SVG_LEFT, "font-weight=\"bold\"", "%d: %s", which + 1,
             words->name);
    svg_text(file, left, CASES_TOP - 14, SVG_LEFT, "", "%s", words->rule);
    svg_text(file, left, below + 30, SVG_LEFT, "font-weight=\"bold\"", "%s", words->next);
    svg_text(file, left, below + 58, SVG_LEFT, "", "node %u, %c = %.3g", step->id,
             "xyz"[node.split_axis], node.split_pos);
    svg_text(file, left, below + 86, SVG_LEFT, "", "t %.3g to %.3g", step->t_min, step->t_max);
    svg_text(file, left, below + 114, SVG_LEFT, "", "t_split %.3g", t_split);
}

void draw_cases(FILE *file, const Followed *followed)
{
    svg_begin(file, CASES_TOP + PANEL_HEIGHT + 190, "The four cases at an inner node",
              "Four nodes that one ray meets. In each panel the coordinate along the split axis "
              "goes to the "
              "right and t upwards; the eye is a circle, the node's part of the ray a thick line, "
              "the plane "
              "an upright line. Where the plane is behind the eye or beyond the part, only the "
              "near child is "
              "met; where it is before the part, only the far one; where it cuts the part, both.");
    svg_title(file, 16, 40, SVG_LEFT, "", "Four nodes on one ray, whose eye is inside the scene");
    for (int which = 0; which < CASES; which++) {
        case_draw(file, followed, which);
    }
    const double y = CASES_TOP + PANEL_HEIGHT + 160;
    svg_box(file, 16, y - 18, 36, 24, "fill=\"" SVG_SKY "\"");
    svg_text(file, 62, y, SVG_LEFT, "", "near side, with the eye");
    svg_line(file, 330, y - 20, 330, y + 6, "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
    svg_text(file, 344, y, SVG_LEFT, "", "the node's plane");
    svg_line(file, 560, y - 6, 600, y - 6, "stroke=\"" SVG_BLACK "\" stroke-width=\"8\"");
    svg_text(file, 612, y, SVG_LEFT, "", "the node's part; t goes up");
    svg_end(file);
}
