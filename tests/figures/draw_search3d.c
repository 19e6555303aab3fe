// 07-search.svg: the search along a ray of the worked example, from above, with the todo stack. The
// notes show one step; in a browser a reader drags the ray and takes the steps (slides-notes/touch).
#include "figures3d.h"

#include <math.h>
#include <string.h>

// From above, in scene units and pixels; the stack beside it; t below both.
enum { LEFT = 24, TOP = 72, UNIT = 150, WIDTH = 610, DEPTH = 450 };
enum { STACK_LEFT = 690, STACK_TOP = 130, STACK_WIDTH = 310, STACK_ROW = 46 };
enum { T_LEFT = 150, T_RIGHT = 940, T_TOP = TOP + DEPTH + 52, BAR = 34 };
enum { WORDS_TOP = T_TOP + BAR + 58, ROW = 29, HEIGHT = WORDS_TOP + 2 * ROW + 24 };
// Narrow, stack and t are moved below the plan.
enum {
    NARROW_WIDTH = 660,
    MOVED_LEFT = 660,
    MOVED_DOWN = 400,
    NARROW_HEIGHT = 740,
    NARROW_TEXT = 23
};
static const double FIRST_X = -2.7, LAST_Y = 1.5, LAST_T = 5;

static double plan_x(double x)
{
    return LEFT + (x - FIRST_X) * UNIT;
}

static double plan_y(double y)
{
    return TOP + (LAST_Y - y) * UNIT;
}

void search3d_point(double x, double y, double *scene_x, double *scene_y)
{
    *scene_x = FIRST_X + fmin(fmax((x - LEFT) / UNIT, 0), (double)WIDTH / UNIT);
    *scene_y = LAST_Y - fmin(fmax((y - TOP) / UNIT, 0), (double)DEPTH / UNIT);
}

// The node at hand at a step, and which step that is: NULL where the ray misses the box.
static const Step *node_at(const Followed *followed, u32 step, u32 *place)
{
    const Step *node = NULL;
    for (u32 i = 0; i <= step; i++) {
        const Step *at = followed_step(&followed->own, i);
        if (at->kind <= STEP_LEAF) {
            node = at;
            *place = i;
        }
    }
    return node;
}

// The nearest hit so far, INFINITY where there is none.
static double nearest_at(const Followed *followed, u32 step)
{
    double nearest = INFINITY;
    for (u32 i = 0; i <= step; i++) {
        const Step *at = followed_step(&followed->own, i);
        if (at->kind == STEP_TEST) {
            nearest = fmin(nearest, at->answer);
        }
    }
    return nearest;
}

// ---- The plan -----------------------------------------------------------------------------------

// A node's cell, which the tree does not keep: the scene's box, cut by the planes above the node.
static BBox3D cell_of(const KdTree3D *tree, u32 id)
{
    if (id == 0) {
        return tree->bounds;
    }
    u32 parent = 0;
    while (tree->nodes[parent].split_axis == KD_LEAF ||
           (tree->nodes[parent].first != id && tree->nodes[parent].first + 1 != id)) {
        parent++;
    }
    const KdNode3 node = tree->nodes[parent];
    BBox3D cell = cell_of(tree, parent);
    if (id == node.first) {
        cell.max[node.split_axis] = node.split_pos;
    } else {
        cell.min[node.split_axis] = node.split_pos;
    }
    return cell;
}

static void cell_draw(FILE *file, const BBox3D *cell, const char *look)
{
    svg_box(file, plan_x(cell->min[0]), plan_y(cell->max[1]), (cell->max[0] - cell->min[0]) * UNIT,
            (cell->max[1] - cell->min[1]) * UNIT, look);
}

// The spheres, cut at the ray's height; the one that is asked has a thick edge.
static void spheres_draw(FILE *file, const Followed *followed, u32 step)
{
    const Sphere *spheres = followed->world->kind->data(followed->world).spheres;
    const Step *last = followed_step(&followed->own, step);
    for (int id = 0; id < followed->world->n_elements; id++) {
        const Sphere sphere = spheres[id];
        const double up = followed->own.origin[2] - sphere.z;
        const double square = (double)sphere.radius * sphere.radius - up * up;
        if (square > 0) {
            const int is_asked = last->kind == STEP_TEST && last->id == (u32)id;
            svg_circle(file, plan_x(sphere.x), plan_y(sphere.y), sqrt(square) * UNIT,
                       is_asked
                           ? "fill=\"" SVG_SKY "\" stroke=\"" SVG_ORANGE "\" stroke-width=\"5\""
                           : "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLUE "\" stroke-width=\"2\"");
            svg_text(file, plan_x(sphere.x), plan_y(sphere.y) + 7, SVG_MIDDLE, "", "sphere %d", id);
        }
    }
}

static void part_draw(FILE *file, const Followed *followed, double t_min, double t_max,
                      const char *look)
{
    const f32 *o = followed->own.origin, *d = followed->own.direction;
    svg_line(file, plan_x(o[0] + t_min * d[0]), plan_y(o[1] + t_min * d[1]),
             plan_x(o[0] + t_max * d[0]), plan_y(o[1] + t_max * d[1]), look);
}

static void point_draw(FILE *file, const Followed *followed, double t, const char *look)
{
    const f32 *o = followed->own.origin, *d = followed->own.direction;
    svg_circle(file, plan_x(o[0] + t * d[0]), plan_y(o[1] + t * d[1]), 8, look);
}

// The plane of an inner node, where it stands upright in the drawing.
static void plane_draw(FILE *file, const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    const BBox3D cell = cell_of(tree, id);
    const char *look = "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\" stroke-dasharray=\"14 6\"";
    if (node.split_axis == 0) {
        svg_line(file, plan_x(node.split_pos), plan_y(cell.max[1]) - 12, plan_x(node.split_pos),
                 plan_y(cell.min[1]) + 12, look);
    } else if (node.split_axis == 1) {
        svg_line(file, plan_x(cell.min[0]) - 12, plan_y(node.split_pos), plan_x(cell.max[0]) + 12,
                 plan_y(node.split_pos), look);
    }
}

// Which child is which, beside the box; not where they lie above each other.
static void children_draw(FILE *file, const KdTree3D *tree, const Step *step)
{
    const KdNode3 node = tree->nodes[step->id];
    for (u32 i = 0; node.split_axis < 2 && i < 2; i++) {
        const BBox3D cell = cell_of(tree, node.first + i);
        const char *name = i == step->side ? "near" : "far";
        const double x = (plan_x(cell.min[0]) + plan_x(cell.max[0])) / 2;
        const double y = (plan_y(cell.min[1]) + plan_y(cell.max[1])) / 2 + 7;
        if (node.split_axis == 0) {
            svg_text(file, x, plan_y(cell.min[1]) + 36, SVG_MIDDLE, SVG_HALO, "%s %u", name,
                     node.first + i);
        } else if (cell.min[0] > tree->bounds.min[0]) {
            svg_text(file, plan_x(cell.max[0]) + 16, y, SVG_LEFT, SVG_HALO, "%s %u", name,
                     node.first + i);
        } else {
            svg_text(file, plan_x(cell.min[0]) - 16, y, SVG_RIGHT, SVG_HALO, "%s %u", name,
                     node.first + i);
        }
    }
}

static void plan_draw(FILE *file, const Followed *followed, u32 step)
{
    const KdTree3D *tree = followed->world->kind->data(followed->world).tree3d;
    u32 place = 0;
    const Step *at = node_at(followed, step, &place);
    fprintf(
        file,
        "<clipPath id=\"plan\"><rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"/></clipPath>\n"
        "<g clip-path=\"url(#plan)\">\n",
        LEFT, TOP, WIDTH, DEPTH);
    cell_draw(file, &tree->bounds, "fill=\"" SVG_PALE "\"");
    if (at != NULL) {
        const BBox3D cell = cell_of(tree, at->id);
        cell_draw(file, &cell,
                  at->kind == STEP_LEAF ? "fill=\"" SVG_SAND "\"" : "fill=\"#ffffff\"");
    }
    spheres_draw(file, followed, step);
    cell_draw(file, &tree->bounds, "fill=\"none\" stroke=\"" SVG_GREY "\" stroke-width=\"2\"");
    if (at != NULL && at->kind == STEP_NODE) {
        children_draw(file, tree, at);
    }
    part_draw(file, followed, 0, 10, "stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    if (at != NULL) {
        const BBox3D cell = cell_of(tree, at->id);
        cell_draw(file, &cell, "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
        StepWaiting waiting[TODO_SIZE];
        const u32 n_waiting = followed_waiting(&followed->own, place, waiting);
        for (u32 i = 0; i < n_waiting; i++) {
            part_draw(file, followed, waiting[i].t_min, waiting[i].t_max,
                      "stroke=\"" SVG_BLACK "\" stroke-width=\"6\" stroke-dasharray=\"5 5\"");
        }
        part_draw(file, followed, at->t_min, at->t_max,
                  "stroke=\"" SVG_BLACK "\" stroke-width=\"9\"");
        if (at->kind == STEP_NODE) {
            plane_draw(file, tree, at->id);
            if (at->met == MET_BOTH) {
                point_draw(file, followed, at->t_split,
                           "fill=\"#ffffff\" stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
            }
        }
    }
    const double nearest = nearest_at(followed, step);
    if (isfinite(nearest)) {
        point_draw(file, followed, nearest, "fill=\"" SVG_BLACK "\"");
    }
    const f32 *o = followed->own.origin;
    svg_circle(file, plan_x(o[0]), plan_y(o[1]), 11,
               "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
    fputs("</g>\n", file);
    // Where a reader takes hold of the ray or the eye (slides-notes/touch/touch.js).
    svg_box(file, LEFT, TOP, WIDTH, DEPTH, "class=\"drag\" fill=\"none\" pointer-events=\"all\"");
}

// ---- The stack ----------------------------------------------------------------------------------

static void stack_row_draw(FILE *file, int row, const char *look, u32 node, double t_min,
                           double t_max)
{
    const double y = STACK_TOP + row * STACK_ROW;
    svg_box(file, STACK_LEFT, y, STACK_WIDTH, STACK_ROW - 10, look);
    svg_text(file, STACK_LEFT + 12, y + 25, SVG_LEFT, "", "node %u", node);
    svg_text(file, STACK_LEFT + STACK_WIDTH - 12, y + 25, SVG_RIGHT, "", "t %.4g to %.4g", t_min,
             t_max);
}

// Who waits at a node, before it is decided where to go on; the nearest on top.
static void stack_draw(FILE *file, const Followed *followed, u32 step)
{
    u32 place = 0;
    const Step *at = node_at(followed, step, &place);
    svg_title(file, STACK_LEFT, STACK_TOP - 18, SVG_LEFT, "", "At hand");
    if (at == NULL) {
        svg_text(file, STACK_LEFT, STACK_TOP + 24, SVG_LEFT, "", "none: the box is not met");
        return;
    }
    stack_row_draw(file, 0,
                   at->kind == STEP_LEAF
                       ? "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\""
                       : "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"",
                   at->id, at->t_min, at->t_max);
    StepWaiting waiting[TODO_SIZE];
    const u32 n_waiting = followed_waiting(&followed->own, place, waiting);
    svg_title(file, STACK_LEFT, STACK_TOP + 2 * STACK_ROW - 14, SVG_LEFT, "", "%s",
              n_waiting > 0 ? "Todo stack, its top first" : "Todo stack: empty");
    for (u32 i = 0; i < n_waiting; i++) {
        const StepWaiting *entry = &waiting[n_waiting - 1 - i];
        stack_row_draw(file, 2 + (int)i,
                       "fill=\"none\" stroke=\"" SVG_BLACK
                       "\" stroke-width=\"2\" stroke-dasharray=\"6 4\"",
                       entry->node, entry->t_min, entry->t_max);
    }
}

// ---- Along t ------------------------------------------------------------------------------------

static double t_x(double t)
{
    return T_LEFT + fmin(fmax(t / LAST_T, 0), 1) * (T_RIGHT - T_LEFT);
}

static void bar_draw(FILE *file, double t_min, double t_max, u32 node, const char *look)
{
    svg_box(file, t_x(t_min), T_TOP, t_x(t_max) - t_x(t_min), BAR, look);
    if (t_x(t_max) - t_x(t_min) > 26) {
        svg_text(file, (t_x(t_min) + t_x(t_max)) / 2, T_TOP + 24, SVG_MIDDLE, "", "%u", node);
    }
}

static void axis_draw(FILE *file, const Followed *followed, u32 step)
{
    u32 place = 0;
    const Step *at = node_at(followed, step, &place);
    svg_arrow(file, T_LEFT, T_TOP + BAR + 6, T_RIGHT + 20, T_TOP + BAR + 6, "stroke-width=\"2\"");
    svg_text(file, T_LEFT - 14, T_TOP + BAR + 12, SVG_RIGHT, "", "t = 0");
    svg_text(file, T_RIGHT + 28, T_TOP + BAR + 12, SVG_LEFT, "", "%g", LAST_T);
    if (at != NULL) {
        StepWaiting waiting[TODO_SIZE];
        const u32 n_waiting = followed_waiting(&followed->own, place, waiting);
        for (u32 i = 0; i < n_waiting; i++) {
            bar_draw(file, waiting[i].t_min, waiting[i].t_max, waiting[i].node,
                     "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-dasharray=\"6 4\"");
        }
        bar_draw(file, at->t_min, at->t_max, at->id,
                 at->kind == STEP_LEAF
                     ? "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\""
                     : "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
        if (at->kind == STEP_NODE && at->met == MET_BOTH) {
            svg_line(file, t_x(at->t_split), T_TOP - 12, t_x(at->t_split), T_TOP + BAR + 6,
                     "stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"");
            svg_text(file, t_x(at->t_split), T_TOP - 18, SVG_MIDDLE, "", "t_split %.4g",
                     at->t_split);
        }
    }
    const double nearest = nearest_at(followed, step);
    if (isfinite(nearest)) {
        svg_circle(file, t_x(nearest), T_TOP + BAR + 6, 8, "fill=\"" SVG_BLACK "\"");
        svg_text(file, t_x(nearest), T_TOP + BAR + 36, SVG_MIDDLE, "", "hit %.4g", nearest);
    }
}

// ---- Words --------------------------------------------------------------------------------------

void search3d_step_tell(FILE *file, const Followed *followed, u32 step)
{
    const f32 *o = followed->own.origin, *d = followed->own.direction;
    const StepWords words = followed_words(followed->world, &followed->own, step);
    fprintf(file, "Ray from (%.3g, %.3g) along (%.3g, %.3g), step %u of %u", o[0], o[1], d[0], d[1],
            step, steps_kept(followed->own.n_steps) - 1);
    for (int i = 0; i < words.n; i++) {
        fprintf(file, "\n%s", words.lines[i] + strspn(words.lines[i], " "));
    }
}

static void words_draw(FILE *file, const Followed *followed, u32 step)
{
    const StepWords words = followed_words(followed->world, &followed->own, step);
    for (int i = 0; i < words.n; i++) {
        svg_text(file, LEFT, WORDS_TOP + i * ROW, SVG_LEFT, "", "%s",
                 words.lines[i] + strspn(words.lines[i], " "));
    }
}

// ---- The whole ----------------------------------------------------------------------------------

void draw_search3d_step(FILE *file, const Followed *followed, u32 step, FigureShape shape)
{
    static const struct {
        int width, height;
    } SIZES[] = {{SVG_WIDTH, HEIGHT}, {SVG_WIDTH, WORDS_TOP - 8}, {NARROW_WIDTH, NARROW_HEIGHT}};
    svg_begin_wide(file, SIZES[shape].width, SIZES[shape].height, "The search along a ray",
                   "Left, from above: the scene's box, the cell and the plane of the node at hand, "
                   "the spheres at the ray's height, and the ray from the eye; its part in the "
                   "node is thick, those of waiting nodes are dashed. Right: the node at hand and "
                   "the todo stack. Below: the same parts along t.");
    if (shape == SHAPE_NARROW) {
        fprintf(file, "<g font-size=\"%d\">\n", NARROW_TEXT);
    }
    svg_title(file, LEFT, 40, SVG_LEFT, "", "The search along a ray: step %u of %u", step,
              steps_kept(followed->own.n_steps) - 1);
    plan_draw(file, followed, step);
    if (shape == SHAPE_NARROW) {
        fprintf(file, "<g transform=\"translate(%d %d)\">\n", -MOVED_LEFT, MOVED_DOWN);
        stack_draw(file, followed, step);
        fputs("</g>\n</g>\n", file);
    } else {
        stack_draw(file, followed, step);
        axis_draw(file, followed, step);
    }
    if (shape == SHAPE_STILL) {
        words_draw(file, followed, step);
    }
    svg_end(file);
}

// The last one at which both children are met.
u32 search3d_still_step(const Followed *followed)
{
    u32 shown = 0;
    for (u32 i = 0; i < steps_kept(followed->own.n_steps); i++) {
        const Step *step = &followed->own.steps[i];
        shown = step->kind == STEP_NODE && step->met == MET_BOTH ? i : shown;
    }
    return shown;
}

void draw_search3d(FILE *file, const Followed *followed)
{
    draw_search3d_step(file, followed, search3d_still_step(followed), SHAPE_STILL);
}
