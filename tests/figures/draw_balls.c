// 07-balls.svg: balls A and B, or why a search must not end at any hit.
#include "figures3d.h"

#include <math.h>

// From above, in scene units and pixels; and t below.
enum { LEFT = 40, UNIT = 112, PLAN_TOP = 70, T_TOP = 372, ROW = 80, BAR = 30, HEIGHT = 560 };
static const double TOP_Y = 2.55, LOWEST_Y = 0.1;

static double plan_x(double x)
{
    return LEFT + x * UNIT;
}

static double plan_y(double y)
{
    return PLAN_TOP + (TOP_Y - y) * UNIT;
}

static void ball_draw(FILE *file, Sphere ball, u32 id)
{
    static const char *const LOOKS[] = {"fill=\"" SVG_SKY "\" fill-opacity=\"0.8\"",
                                        "fill=\"" SVG_SAND "\"", "fill=\"" SVG_PALE "\""};
    svg_circle(file, plan_x(ball.x), plan_y(ball.y), ball.radius * UNIT, LOOKS[id]);
    svg_circle(file, plan_x(ball.x), plan_y(ball.y), ball.radius * UNIT,
               "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    svg_title(file, plan_x(ball.x), plan_y(ball.y + 0.35 * ball.radius) + 8, SVG_MIDDLE, "", "%c",
              "ABC"[id]);
}

static void hit_draw(FILE *file, const Followed *followed, double t, const char *look)
{
    svg_circle(file, plan_x(followed->own.origin[0] + t), plan_y(followed->own.origin[1]), 8, look);
}

static void plan_draw(FILE *file, const Followed *followed)
{
    const WorldData data = followed->world->kind->data(followed->world);
    const BBox3D box = data.tree3d->bounds;
    const double bottom = plan_y(LOWEST_Y);
    const KdNode3 root = data.tree3d->nodes[0];
    svg_box(file, plan_x(box.min[0]), plan_y(box.max[1]), (box.max[0] - box.min[0]) * UNIT,
            bottom + 2 - plan_y(box.max[1]), "fill=\"none\" stroke=\"" SVG_BLACK "\"");
    for (u32 id = 0; id < 3; id++) {
        // The large one first, so that the small ones are seen.
        ball_draw(file, data.spheres[id], id);
    }
    // What is below is of no use here: the box stays open.
    svg_box(file, 0, bottom, SVG_WIDTH, HEIGHT - bottom, "fill=\"#ffffff\"");
    svg_line(file, plan_x(root.split_pos), plan_y(box.max[1]) - 14, plan_x(root.split_pos), bottom,
             "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
    svg_text(file, plan_x(root.split_pos) - 10, plan_y(box.max[1]) - 8, SVG_RIGHT, SVG_HALO,
             "the plane, x = %g", root.split_pos);
    svg_text(file, plan_x(box.min[0]) + 10, bottom - 12, SVG_LEFT, SVG_HALO, "leaf %u: A, C",
             root.first);
    svg_text(file, plan_x(box.max[0]) - 10, bottom - 12, SVG_RIGHT, SVG_HALO, "leaf %u: A, B",
             root.first + 1);

    const double y = plan_y(followed->own.origin[1]), eye = plan_x(followed->own.origin[0]);
    svg_arrow(file, eye, y, 1010, y, "stroke-width=\"3\"");
    svg_circle(file, eye, y, 9, "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    svg_text(file, eye, y + 34, SVG_MIDDLE, "", "eye");
}

// One leaf's row along t: its part, and what it found.
static void leaf_draw(FILE *file, const Followed *followed, const Step *leaf, int row, double hit,
                      const char *look, const char *found, const char *then)
{
    const double y = T_TOP + row * ROW, x = plan_x(leaf->t_min);
    svg_box(file, x, y, plan_x(leaf->t_max) - x, BAR,
            "fill=\"" SVG_PALE "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    svg_text(file, plan_x(leaf->t_max) - 10, y + 22, SVG_RIGHT, "", "leaf %u: t %.4g to %.4g",
             leaf->id, leaf->t_min, leaf->t_max);
    svg_line(file, plan_x(hit), plan_y(followed->own.origin[1]) + 8, plan_x(hit), y + BAR / 2.0,
             "stroke=\"" SVG_BLACK "\" stroke-width=\"1.5\" stroke-dasharray=\"2 6\"");
    svg_circle(file, plan_x(hit), y + BAR / 2.0, 8, look);
    svg_text(file, plan_x(0) + 10, y + BAR + 26, SVG_LEFT, "", "%s at t %.4g: %s", found, hit,
             then);
}

void draw_balls(FILE *file, const Followed *followed)
{
    svg_begin(file, HEIGHT, "Balls A and B: a hit outside of the node's part",
              "A ray goes to the right through two leaves, parted by a plane. Ball A reaches into "
              "both and is hit behind the plane; ball B stands in the second only and is hit "
              "before A. The first leaf knows A alone, and its hit lies beyond the leaf's part: it "
              "is kept, and the search goes on. The second leaf finds B, nearer and within its "
              "part: the end.");
    svg_title(file, 24, 40, SVG_LEFT, "", "The first leaf finds A; what is seen is B");
    plan_draw(file, followed);
    const Steps *own = &followed->own;
    // Each leaf, and the nearest hit when it had been searched.
    const Step *leaf = NULL;
    double nearest = INFINITY;
    int row = 0;
    for (u32 i = 0; i < steps_kept(own->n_steps); i++) {
        const Step *step = &own->steps[i];
        if (step->kind == STEP_LEAF) {
            leaf = step;
        } else if (step->kind == STEP_TEST && step->answer < nearest) {
            nearest = step->answer;
            const int is_end = step->answer < leaf->t_max;
            const char *look = is_end ? "fill=\"" SVG_BLACK "\""
                                      : "fill=\"#ffffff\" stroke=\"" SVG_BLACK
                                        "\" stroke-width=\"3\"";
            hit_draw(file, followed, step->answer, look);
            leaf_draw(file, followed, leaf, row++, step->answer, look, step->id == 0 ? "A" : "B",
                      is_end ? "before t_max, so all that waits is farther. The end"
                             : "beyond t_max. Keep it, and go on");
        }
    }
    svg_text(file, 24, HEIGHT - 18, SVG_LEFT, "fill=\"" SVG_GREY "\"",
             "White: the hit that was kept first; black: the one that is seen. C is missed.");
    svg_end(file);
}
