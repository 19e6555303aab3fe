// 03-search.svg: the search for a pixel's leaf in the plane and in the tree beside it. The notes
// show its last step; in a browser a reader drags the pixel and takes the steps
// (slides-notes/touch).
#include "figures2d.h"

#include <string.h>

// Pixels. The tree stands where 02-tree.svg has it; narrow, it is moved below the plane.
enum { LEFT = 40, TOP = 88, SIDE = 400, WORDS_TOP = TOP + SIDE + 66, ROW = 29 };
enum { HEIGHT = WORDS_TOP + 2 * ROW + 24 };
enum { NARROW_WIDTH = 520, TREE_MOVED_LEFT = 506, TREE_MOVED_DOWN = 450, NARROW_HEIGHT = 930 };

// The node at hand at a step: the last one that was entered.
static const Step *node_at(const Followed *followed, u32 step)
{
    const Step *node = NULL;
    for (u32 i = 0; i <= step; i++) {
        const Step *at = followed_step(&followed->own, i);
        node = at->kind <= STEP_LEAF ? at : node;
    }
    return node;
}

// ---- The plane ----------------------------------------------------------------------------------

// The circle that covers the pixel and is nearest so far is filled; the one that is asked has a
// thick edge.
static void asked_draw(FILE *file, const Plane2D *plane, const Followed *followed, u32 step)
{
    const Circle *circles = followed->world->kind->data(followed->world).circles;
    u32 nearest = NO_ID;
    for (u32 i = 0; i <= step; i++) {
        const Step *at = followed_step(&followed->own, i);
        if (at->kind == STEP_TEST && followed_is_hit(followed->world, at)) {
            nearest = at->id;
        }
    }
    const Step *last = followed_step(&followed->own, step);
    const u32 shown[] = {nearest, last->kind == STEP_TEST ? last->id : NO_ID};
    static const char *const LOOKS[] = {"fill=\"" SVG_BLUE "\" fill-opacity=\"0.45\"",
                                        "fill=\"none\" stroke=\"" SVG_ORANGE
                                        "\" stroke-width=\"5\""};
    for (int i = 0; i < 2; i++) {
        if (shown[i] != NO_ID) {
            const Circle circle = circles[shown[i]];
            const double x = plane2d_x(plane, circle.x);
            svg_circle(file, x, plane2d_y(plane, circle.y),
                       plane2d_x(plane, circle.x + circle.radius) - x, LOOKS[i]);
        }
    }
}

static void leaf_cells_draw(FILE *file, const Plane2D *plane, const KdTree2D *tree)
{
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == LEAF) {
            const BBox2D box = tree->nodes_BBox[id];
            plane2d_cell(file, plane, box, "fill=\"none\" stroke=\"" SVG_GREY "\"");
            svg_text(file, plane2d_x(plane, box.minX) + 6, plane2d_y(plane, box.minY) + 22,
                     SVG_LEFT, SVG_HALO, "%u", id);
        }
    }
}

static void axes_draw(FILE *file, const Plane2D *plane)
{
    const f32 marks_x[] = {plane->root.minX, plane->root.maxX};
    const f32 marks_y[] = {plane->root.minY, plane->root.maxY};
    for (int i = 0; i < 2; i++) {
        svg_text(file, plane2d_x(plane, marks_x[i]), TOP + SIDE + 26, SVG_MIDDLE, "", "%g",
                 marks_x[i]);
        svg_text(file, LEFT - 8, plane2d_y(plane, marks_y[i]) + (i == 0 ? 16 : 0), SVG_RIGHT, "",
                 "%g", marks_y[i]);
    }
}

static void plane_draw(FILE *file, const Followed *followed, u32 step)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    const Plane2D plane = plane2d_at(followed, LEFT, TOP, SIDE);
    const Step *node = node_at(followed, step);
    const BBox2D box = tree->nodes_BBox[node->id];
    plane2d_cell(file, &plane, tree->nodes_BBox[0], "fill=\"" SVG_PALE "\"");
    plane2d_cell(file, &plane, box,
                 node->kind == STEP_LEAF ? "fill=\"" SVG_SAND "\"" : "fill=\"#ffffff\"");
    plane2d_circles(file, &plane, followed);
    leaf_cells_draw(file, &plane, tree);
    asked_draw(file, &plane, followed, step);
    if (node->kind == STEP_NODE) {
        plane2d_cell(file, &plane, tree->nodes_BBox[tree->nodes_Relations[node->id].lChild],
                     "fill=\"none\" stroke=\"" SVG_BLACK
                     "\" stroke-width=\"3\" stroke-dasharray=\"8 6\"");
    }
    plane2d_cell(file, &plane, box, "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"5\"");
    plane2d_pixel(file, &plane, followed);
    plane2d_letters(file, &plane, followed);
    axes_draw(file, &plane);
    // Where a reader takes hold of the pixel (slides-notes/touch/touch.js).
    svg_box(file, LEFT, TOP, SIDE, SIDE, "class=\"drag\" fill=\"none\" pointer-events=\"all\"");
}

// ---- The tree -----------------------------------------------------------------------------------

// The way down so far is thick; the node at hand has a ring.
static void tree_draw(FILE *file, const Followed *followed, u32 step)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    const Step *from = followed_step(&followed->own, 0);
    for (u32 i = 1; i <= step; i++) {
        const Step *to = followed_step(&followed->own, i);
        if (to->kind > STEP_LEAF) {
            break;
        }
        svg_line(file, tree2d_x(from->id), tree2d_y(from->id), tree2d_x(to->id), tree2d_y(to->id),
                 "stroke=\"" SVG_ORANGE "\" stroke-width=\"9\"");
        from = to;
    }
    const int is_leaf = from->kind == STEP_LEAF;
    tree2d_nodes(file, tree, is_leaf ? from->id : NO_ID);
    if (!is_leaf) {
        svg_circle(file, tree2d_x(from->id), tree2d_y(from->id), 24,
                   "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"5\"");
    }
}

// ---- Words --------------------------------------------------------------------------------------

// The nodes on the way down, and how many circles were asked.
static void way_tell(const Followed *followed, char line[STEP_LINE_BYTES])
{
    int length = snprintf(line, STEP_LINE_BYTES, "the way: node");
    const Step *step = followed_step(&followed->own, 0);
    for (u32 i = 1; step->kind == STEP_NODE; i++) {
        length += snprintf(line + length, STEP_LINE_BYTES - (size_t)length, " %u,", step->id);
        step = followed_step(&followed->own, i);
    }
    snprintf(line + length, STEP_LINE_BYTES - (size_t)length, " leaf %u; tested: %u of %d circles",
             step->id, followed->own.n_tests, followed->world->n_elements);
}

// The step as `make pixel` says it, and what comes of it.
static StepWords step_words(const Followed *followed, u32 i)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    const Step *step = followed_step(&followed->own, i);
    StepWords words = followed_words(followed->world, &followed->own, i);
    char *line = words.lines[words.n];
    if (step->kind == STEP_NODE) {
        const u32 child = followed_step(&followed->own, i + 1)->id;
        const int is_left = child == tree->nodes_Relations[step->id].lChild;
        snprintf(line, STEP_LINE_BYTES, "pixel %d, %d is %s the left child: go to %u", followed->x,
                 followed->y, is_left ? "in" : "not in", child);
        words.n++;
    } else if (step->kind == STEP_TEST) {
        snprintf(line, STEP_LINE_BYTES, "which is %c: %s", circle_letter(step->id),
                 followed_is_hit(followed->world, step)
                     ? "it covers the pixel, nearer than all before"
                     : "it does not cover the pixel, or is not nearer");
        words.n++;
    } else if (step->kind == STEP_END) {
        way_tell(followed, line);
        words.n++;
    }
    return words;
}

void search_step_tell(FILE *file, const Followed *followed, u32 step)
{
    const StepWords words = step_words(followed, step);
    fprintf(file, "Pixel %d, %d, step %u of %u", followed->x, followed->y, step,
            steps_kept(followed->own.n_steps) - 1);
    for (int i = 0; i < words.n; i++) {
        const char *line = words.lines[i] + strspn(words.lines[i], " ");
        fprintf(file, "\n%s", line);
    }
}

// ---- The whole ----------------------------------------------------------------------------------

static void words_draw(FILE *file, const Followed *followed, u32 step)
{
    const StepWords words = step_words(followed, step);
    for (int i = 0; i < words.n; i++) {
        const char *line = words.lines[i] + strspn(words.lines[i], " ");
        svg_text(file, LEFT, WORDS_TOP + i * ROW, SVG_LEFT, "", "%s", line);
    }
}

void draw_search_step(FILE *file, const Followed *followed, u32 step, FigureShape shape)
{
    const char *description =
        "Left: five circles A to E in a square from 0 to 10, cut into eight cells, the leaves 7 to "
        "14; the cell of the node at hand is marked, a cross is the pixel. Right: the tree, with "
        "the way from the root to that node.";
    static const struct {
        int width, height;
    } SIZES[] = {{SVG_WIDTH, HEIGHT}, {SVG_WIDTH, WORDS_TOP - ROW}, {NARROW_WIDTH, NARROW_HEIGHT}};
    svg_begin_wide(file, SIZES[shape].width, SIZES[shape].height, "The search for a pixel's leaf",
                   description);
    svg_title(file, LEFT, 40, SVG_LEFT, "", "Pixel %d, %d: step %u of %u", followed->x, followed->y,
              step, steps_kept(followed->own.n_steps) - 1);
    plane_draw(file, followed, step);
    if (shape == SHAPE_NARROW) {
        fprintf(file, "<g transform=\"translate(%d %d)\">\n", -TREE_MOVED_LEFT, TREE_MOVED_DOWN);
        tree_draw(file, followed, step);
        fputs("</g>\n", file);
    } else {
        tree_draw(file, followed, step);
    }
    if (shape == SHAPE_STILL) {
        words_draw(file, followed, step);
    }
    svg_end(file);
}

void search_point(const Followed *followed, double x, double y, double *scene_x, double *scene_y)
{
    const BBox2D root = plane2d_at(followed, LEFT, TOP, SIDE).root;
    const double scale = ((double)root.maxX - root.minX) / SIDE;
    *scene_x = root.minX + (x - LEFT) * scale;
    *scene_y = root.minY + (y - TOP) * scale;
}

void draw_search(FILE *file, const Followed *followed)
{
    draw_search_step(file, followed, steps_kept(followed->own.n_steps) - 1, SHAPE_STILL);
}
