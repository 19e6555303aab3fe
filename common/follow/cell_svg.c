// A pixel's cells as a picture (see followed_svg.h): the last levels of its way down, so that the
// leaf is large enough to be seen, and the steps in words.
//
// Called by followed_svg.c.
#include "followed_svg.h"

#include "message.h"

#include <math.h>

// The plane's place in the picture, and the words' beside it. Pixels.
enum { LEFT = 16, TOP = 64, SIDE = 600, WORDS = 644, ROW = 30, MOST_ROWS = 18 };
enum { HEIGHT = TOP + SIDE + 40 };

// How many levels above the leaf are drawn.
enum { LEVELS_SHOWN = 4 };

// The part of the scene that is shown, and how many pixels of the drawing one of its pixels is.
typedef struct Plane {
    FILE *file;
    const World *world;
    BBox2D box;
    double scale;
} Plane;

static double x_of(const Plane *plane, double x)
{
    return LEFT + (x - plane->box.minX) * plane->scale;
}

static double y_of(const Plane *plane, double y)
{
    return TOP + (y - plane->box.minY) * plane->scale;
}

// The cell a few levels above the leaf, or, without a tree, the picture.
static void plane_set(Plane *plane, const Steps *steps)
{
    const KdTree2D *tree = plane->world->kind->data(plane->world).tree2d;
    plane->box = (BBox2D){0, (f32)plane->world->width, 0, (f32)plane->world->height};
    if (tree != NULL) {
        const u32 n_nodes = steps->n_nodes_visited;
        const Step *shown =
            followed_step(steps, n_nodes > LEVELS_SHOWN ? n_nodes - LEVELS_SHOWN : 0);
        if (shown != NULL && shown->kind <= STEP_LEAF && shown->id < tree->n_nodes) {
            plane->box = tree->nodes_BBox[shown->id];
        }
    }
    const double width = (double)plane->box.maxX - plane->box.minX;
    const double height = (double)plane->box.maxY - plane->box.minY;
    plane->scale = SIDE / fmax(width, height);
}

// ---- The plane ----------------------------------------------------------------------------------

static void circle_draw(const Plane *plane, const Circle *circle, const char *look)
{
    svg_circle(plane->file, x_of(plane, circle->x), y_of(plane, circle->y),
               circle->radius * plane->scale, look);
}

static int is_near_plane(const Plane *plane, const Circle *circle)
{
    return circle->x + circle->radius >= plane->box.minX &&
           circle->x - circle->radius <= plane->box.maxX &&
           circle->y + circle->radius >= plane->box.minY &&
           circle->y - circle->radius <= plane->box.maxY;
}

// All circles that reach into it, thin; those that are asked, thick; the one that is seen, filled.
static void circles_draw(const Plane *plane, const Steps *steps)
{
    const Circle *circles = plane->world->kind->data(plane->world).circles;
    for (int id = 0; id < plane->world->n_elements; id++) {
        if (is_near_plane(plane, &circles[id])) {
            circle_draw(plane, &circles[id], "fill=\"none\" stroke=\"" SVG_GREY "\"");
        }
    }
    u32 seen = NO_ID;
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        const Step *step = &steps->steps[i];
        if (step->kind == STEP_TEST && step->id != NO_ID) {
            seen = followed_is_hit(plane->world, step) ? step->id : seen;
            circle_draw(plane, &circles[step->id],
                        "fill=\"none\" stroke=\"" SVG_BLUE "\" stroke-width=\"3\"");
        }
    }
    if (seen != NO_ID) {
        circle_draw(plane, &circles[seen], "fill=\"" SVG_SKY "\" fill-opacity=\"0.8\"");
    }
}

static void cell_draw(const Plane *plane, u32 id, int is_leaf)
{
    const KdTree2D *tree = plane->world->kind->data(plane->world).tree2d;
    if (id >= tree->n_nodes) {
        return;
    }
    const BBox2D box = tree->nodes_BBox[id];
    const double width = ((double)box.maxX - box.minX) * plane->scale;
    const double height = ((double)box.maxY - box.minY) * plane->scale;
    svg_box(plane->file, x_of(plane, box.minX), y_of(plane, box.minY), width, height,
            is_leaf ? "fill=\"" SVG_SAND "\" fill-opacity=\"0.5\" stroke=\"" SVG_BLACK
                      "\" stroke-width=\"5\""
                    : "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
}

static void plane_draw(const Plane *plane, const Followed *followed)
{
    FILE *file = plane->file;
    fprintf(
        file,
        "<clipPath id=\"plane\"><rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"/></clipPath>\n"
        "<g clip-path=\"url(#plane)\">\n",
        LEFT - 4, TOP - 4, SIDE + 8, SIDE + 8);
    circles_draw(plane, &followed->own);
    for (u32 i = 0; i < steps_kept(followed->own.n_steps); i++) {
        const Step *step = &followed->own.steps[i];
        if (step->kind <= STEP_LEAF) {
            cell_draw(plane, step->id, step->kind == STEP_LEAF);
        }
    }
    svg_cross(file, x_of(plane, followed->x), y_of(plane, followed->y), 9,
              "stroke=\"" SVG_ORANGE "\" stroke-width=\"4\"");
    fputs("</g>\n", file);
    svg_text(file, LEFT, TOP + SIDE + 28, SVG_LEFT, "", "x %g to %g, y %g to %g (downwards)",
             plane->box.minX, plane->box.maxX, plane->box.minY, plane->box.maxY);
}

// ---- The words ----------------------------------------------------------------------------------

static void words_draw(const Plane *plane, const Steps *steps, u32 i, double y)
{
    const Step *step = &steps->steps[i];
    FILE *file = plane->file;
    svg_text(file, WORDS + 36, y, SVG_RIGHT, "fill=\"" SVG_GREY "\"", "%u", i);
    switch (step->kind) {
    case STEP_TEST:
        svg_text(file, WORDS + 48, y, SVG_LEFT, "", "  circle %u: %s", step->id,
                 followed_is_hit(plane->world, step) ? "nearest so far" : "no");
        break;
    case STEP_END:
        svg_text(file, WORDS + 48, y, SVG_LEFT, "", "colour %.2g %.2g %.2g", step->element[0],
                 step->element[1], step->element[2]);
        break;
    default:
        svg_text(file, WORDS + 48, y, SVG_LEFT, "", "%s %u",
                 step->kind == STEP_LEAF ? "leaf" : "node", step->id);
    }
}

// The steps from `first` on, as many as there is room for. Returns the y of what comes below.
static double list_draw(const Plane *plane, const Steps *steps, u32 first, u32 most, double y)
{
    const u32 n_steps = steps_kept(steps->n_steps);
    for (u32 i = first; i < n_steps; i++, y += ROW) {
        // The last row says how it ends.
        if (i - first + 2 == most && n_steps - i > 2) {
            svg_text(plane->file, WORDS + 48, y, SVG_LEFT, "", "and %u more", n_steps - 1 - i);
            i = n_steps - 2;
        } else {
            words_draw(plane, steps, i, y);
        }
    }
    return y;
}

void cell_svg(const Followed *followed, FILE *file)
{
    const Options *options = &followed->world->lab->options;
    char scene[MESSAGE_SHOWN_BYTES / 2], title[160];
    snprintf(title, sizeof title, "%s, %s: pixel %d, %d", followed->world->lab->name,
             message_show(options->scene, scene, sizeof scene), followed->x, followed->y);
    Plane plane = {.file = file, .world = followed->world};
    plane_set(&plane, &followed->own);
    svg_begin(file, HEIGHT, title, "The cells and circles of a pixel: followed by make pixel.");
    svg_title(file, 16, 36, SVG_LEFT, "", "%s", title);
    plane_draw(&plane, followed);
    if (followed->parting < 0) {
        list_draw(&plane, &followed->own, 0, MOST_ROWS, TOP + 24);
    } else {
        const u32 parting = (u32)followed->parting, half = MOST_ROWS / 2 - 1;
        svg_text(file, WORDS, TOP + 24, SVG_LEFT, "font-weight=\"bold\"",
                 "They part at step %u. Your kernel:", parting);
        const double y = list_draw(&plane, &followed->own, parting, half, TOP + 24 + ROW);
        svg_text(file, WORDS, y + ROW / 2, SVG_LEFT, "font-weight=\"bold\"", "The reference:");
        list_draw(&plane, &followed->reference, parting, half, y + ROW / 2 + ROW);
    }
    svg_end(file);
}
