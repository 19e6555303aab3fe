// A ray's steps as a picture (see followed_svg.h).
//
// Read next: cell_svg.c.
#include "followed_svg.h"

#include "message.h"

#include <math.h>
#include <string.h>

// Rows, and where the axis of t begins and ends. Pixels.
enum { TOP = 96, ROW = 34, BAR = 24, AXIS_LEFT = 390, AXIS_RIGHT = 1000 };

// Numbers of spheres in one row of misses.
enum { MISS_LETTERS = 44 };

typedef struct Rows {
    FILE *file;
    const World *world;
    double t_first, t_last;  // at AXIS_LEFT and AXIS_RIGHT
    double y;                // of the row at hand, its top
} Rows;

static double x_of(const Rows *rows, double t)
{
    const double share = (t - rows->t_first) / (rows->t_last - rows->t_first);
    return AXIS_LEFT + fmin(fmax(share, 0), 1) * (AXIS_RIGHT - AXIS_LEFT);
}

// ---- What a row shows ---------------------------------------------------------------------------

// The number of a node in the middle of these t, where there is room.
static void number_draw(const Rows *rows, double t_min, double t_max, u32 node)
{
    const double left = x_of(rows, t_min), right = x_of(rows, t_max);
    char name[16];
    snprintf(name, sizeof name, "%u", node);
    if (node != NO_ID && svg_text_width(name) + 6 < right - left) {
        svg_text(rows->file, (left + right) / 2, rows->y + BAR - 2, SVG_MIDDLE, "", "%s", name);
    }
}

// The part of a node.
static void part_draw(const Rows *rows, double t_min, double t_max, const char *look)
{
    const double left = x_of(rows, t_min), right = x_of(rows, t_max);
    if (right > left) {
        svg_box(rows->file, left, rows->y + 4, right - left, BAR, look);
    }
}

static void visit_draw(const Rows *rows, const Steps *steps, u32 i)
{
    const Step *step = &steps->steps[i];
    const KdTree3D *tree = rows->world->kind->data(rows->world).tree3d;
    const int is_leaf = step->kind == STEP_LEAF;
    char plane[48] = "";
    if (!is_leaf && step->id < tree->n_nodes) {
        const KdNode3 node = tree->nodes[step->id];
        snprintf(plane, sizeof plane, ": %c = %.4g", "xyz?"[node.split_axis & 3], node.split_pos);
    }
    svg_text(rows->file, 64, rows->y + BAR - 2, SVG_LEFT, "", "%s %u%s", is_leaf ? "leaf" : "node",
             step->id, plane);

    StepWaiting waiting[TODO_SIZE];
    const u32 n_waiting = followed_waiting(steps, i, waiting);
    for (u32 k = 0; k < n_waiting; k++) {
        part_draw(rows, waiting[k].t_min, waiting[k].t_max,
                  "fill=\"none\" stroke=\"" SVG_GREY "\" stroke-dasharray=\"5 4\"");
        number_draw(rows, waiting[k].t_min, waiting[k].t_max, waiting[k].node);
    }
    part_draw(rows, step->t_min, step->t_max,
              is_leaf ? "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\""
                      : "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLACK "\"");
    double number_to = step->t_max;
    if (!is_leaf && step->met == MET_BOTH) {
        number_to = step->t_split;  // beside the line, not under it
        const double x = x_of(rows, step->t_split);
        svg_line(rows->file, x, rows->y, x, rows->y + ROW - 2,
                 "stroke=\"" SVG_ORANGE "\" stroke-width=\"4\"");
    }
    number_draw(rows, step->t_min, number_to, step->id);
}

// One sphere that is hit, or the end.
static void hit_draw(const Rows *rows, const char *text, double t)
{
    svg_text(rows->file, 64, rows->y + BAR - 2, SVG_LEFT, "", "%s", text);
    if (isfinite(t)) {
        svg_circle(rows->file, x_of(rows, t), rows->y + ROW / 2, 7, "fill=\"" SVG_BLACK "\"");
    }
}

// All misses from step i on that follow each other in one row. Returns how many.
static u32 misses_draw(const Rows *rows, const Steps *steps, u32 i)
{
    char text[128] = "  missed:";
    u32 n = 0, n_told = 0;
    const Step *step;
    while ((step = followed_step(steps, i + n)) != NULL && step->kind == STEP_TEST &&
           !followed_is_hit(rows->world, step)) {
        char id[16];
        snprintf(id, sizeof id, " %u", step->id);
        if (n_told == n && strlen(text) + strlen(id) < MISS_LETTERS) {
            strcat(text, id);
            n_told++;
        }
        n++;
    }
    char more[32] = "";
    if (n_told < n) {
        snprintf(more, sizeof more, " and %u more", n - n_told);
    }
    svg_text(rows->file, 64, rows->y + BAR - 2, SVG_LEFT, "", "%s%s", text, more);
    return n;
}

// One row. Returns how many steps it shows.
static u32 row_draw(Rows *rows, const Steps *steps, u32 i)
{
    const Step *step = &steps->steps[i];
    char text[64];
    u32 n_steps = 1;
    svg_text(rows->file, 52, rows->y + BAR - 2, SVG_RIGHT, "fill=\"" SVG_GREY "\"", "%u", i);
    if (step->kind == STEP_TEST && !followed_is_hit(rows->world, step)) {
        n_steps = misses_draw(rows, steps, i);
    } else if (step->kind == STEP_TEST) {
        snprintf(text, sizeof text, "  sphere %u: t %.5g", step->id, step->answer);
        hit_draw(rows, text, step->answer);
    } else if (step->kind != STEP_END) {
        visit_draw(rows, steps, i);
    } else if (isfinite(step->nearest)) {
        snprintf(text, sizeof text, "hit: sphere %u, t %.5g", step->id, step->nearest);
        hit_draw(rows, text, step->nearest);
    } else {
        hit_draw(rows, "hit: none", INFINITY);
    }
    rows->y += ROW;
    return n_steps;
}

// ---- The whole ----------------------------------------------------------------------------------

// From where to where t goes: that of the box, or, where there is none, of the hits.
static void axis_set(Rows *rows, const Steps *steps)
{
    rows->t_first = 0;
    rows->t_last = 1;
    if (steps->steps[0].kind <= STEP_LEAF) {
        rows->t_first = steps->steps[0].t_min;
        rows->t_last = steps->steps[0].t_max;
    }
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        const Step *step = &steps->steps[i];
        if (step->kind == STEP_TEST && isfinite(step->answer)) {
            rows->t_last = fmax(rows->t_last, step->answer);
        }
    }
    // What a student's kernel says may be anything.
    if (!(rows->t_first < rows->t_last) || !isfinite(rows->t_last - rows->t_first)) {
        rows->t_first = 0;
        rows->t_last = 1;
    }
}

static void axis_draw(const Rows *rows)
{
    svg_text(rows->file, AXIS_LEFT, TOP - 14, SVG_LEFT, "", "t = %.4g", rows->t_first);
    svg_text(rows->file, AXIS_RIGHT, TOP - 14, SVG_RIGHT, "", "%.4g", rows->t_last);
    svg_arrow(rows->file, AXIS_LEFT, TOP - 5, AXIS_RIGHT, TOP - 5, "stroke-width=\"2\"");
}

static void legend_draw(const Rows *rows)
{
    FILE *file = rows->file;
    const double y = rows->y + 22;
    svg_box(file, 16, y, 36, BAR, "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLACK "\"");
    svg_text(file, 60, y + 18, SVG_LEFT, "", "inner node");
    svg_box(file, 190, y, 36, BAR,
            "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"");
    svg_text(file, 234, y + 18, SVG_LEFT, "", "leaf");
    svg_box(file, 310, y, 36, BAR,
            "fill=\"none\" stroke=\"" SVG_GREY "\" stroke-dasharray=\"5 4\"");
    svg_text(file, 354, y + 18, SVG_LEFT, "", "waits");
    svg_line(file, 450, y - 2, 450, y + BAR + 2, "stroke=\"" SVG_ORANGE "\" stroke-width=\"4\"");
    svg_text(file, 462, y + 18, SVG_LEFT, "", "t_split: both children are met");
    svg_circle(file, 806, y + 12, 7, "fill=\"" SVG_BLACK "\"");
    svg_text(file, 822, y + 18, SVG_LEFT, "", "hit");
}

// The rows of steps from..to.
static void rows_draw(Rows *rows, const Steps *steps, u32 from, u32 to)
{
    for (u32 i = from; i < to;) {
        i += row_draw(rows, steps, i);
    }
}

// How many rows that are: misses that follow each other share one.
static int rows_count(const World *world, const Steps *steps, u32 from, u32 to)
{
    int n_rows = 0, was_miss = 0;
    for (u32 i = from; i < to; i++) {
        const Step *step = &steps->steps[i];
        const int is_miss = step->kind == STEP_TEST && !followed_is_hit(world, step);
        n_rows += !(is_miss && was_miss);
        was_miss = is_miss;
    }
    return n_rows;
}

static void heading_draw(Rows *rows, const char *text)
{
    svg_text(rows->file, 16, rows->y + BAR - 2, SVG_LEFT, "font-weight=\"bold\"", "%s", text);
    rows->y += ROW;
}

void ray_svg(const Followed *followed, FILE *file)
{
    const Steps *own = &followed->own, *right = &followed->reference;
    const u32 n_own = steps_kept(own->n_steps), n_right = steps_kept(right->n_steps);
    const int parts = followed->parting >= 0;
    const u32 parting = parts ? (u32)followed->parting : n_own;
    int n_rows = rows_count(followed->world, own, 0, parting);
    if (parts) {
        n_rows += 2 + rows_count(followed->world, own, parting, n_own) +
                  rows_count(followed->world, right, parting, n_right);
    }
    const Options *options = &followed->world->lab->options;
    char scene[MESSAGE_SHOWN_BYTES / 2], title[160];
    snprintf(title, sizeof title, "%s, %s: pixel %d, %d", followed->world->lab->name,
             message_show(options->scene, scene, sizeof scene), followed->x, followed->y);

    Rows rows = {.file = file, .world = followed->world, .y = TOP};
    axis_set(&rows, parts && n_right > 0 ? right : own);
    svg_begin(file, TOP + n_rows * ROW + 64, title, "The steps of a ray: followed by make pixel.");
    svg_title(file, 16, 36, SVG_LEFT, "", "%s", title);
    axis_draw(&rows);
    rows_draw(&rows, own, 0, parting);
    if (parts) {
        heading_draw(&rows, followed->is_close ? "Here they part, as rounding decides. Your kernel:"
                                               : "Here they part. Your kernel:");
        rows_draw(&rows, own, parting, n_own);
        heading_draw(&rows, "The reference:");
        rows_draw(&rows, right, parting, n_right);
    }
    legend_draw(&rows);
    svg_end(file);
}
