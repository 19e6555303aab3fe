// 10-borders.svg: where planes may be in lab 10's Part A. The same circles, cut by the trees of lab
// 02 and of lab 10: a tile is in several leaves of the one, and in one leaf of the other.
#include "figures2d.h"

#include "circle_tree.h"
#include "kdtree2d_build.h"

#include "lab.h"

#include <math.h>

// Two panels side by side; the scene has COLUMNS x ROWS tiles. Pixels.
enum { LEFT = 16, PANEL = 488, GAP = 16, TOP = 92, HEIGHT = 512 };
enum { COLUMNS = 8, ROWS = 6, N_CIRCLES = 34, SEED = 4 };
static const KdTreeLimits LIMITS = {7, 2};
// The tile that is marked: column and row.
static const int MARKED[2] = {5, 4};
static const double SCALE = (double)PANEL / (COLUMNS * CIRCLE_TILE_SIDE);

static BBox2D marked_box(void)
{
    const float side = CIRCLE_TILE_SIDE;
    return (BBox2D){MARKED[0] * side, (MARKED[0] + 1) * side, MARKED[1] * side,
                    (MARKED[1] + 1) * side};
}

static void box_draw(FILE *file, double left, BBox2D box, const char *look)
{
    svg_box(file, left + box.minX * SCALE, TOP + box.minY * SCALE,
            ((double)box.maxX - box.minX) * SCALE, ((double)box.maxY - box.minY) * SCALE, look);
}

// Tiles and circles.
static void scene_draw(FILE *file, const Scene2D *scene, double left)
{
    const BBox2D all = {0, (float)scene->width, 0, (float)scene->height};
    fprintf(file, "<svg x=\"%g\" y=\"%d\" width=\"%d\" height=\"%g\">\n", left, TOP, PANEL,
            scene->height * SCALE);
    if (left == LEFT) {
        svg_group_begin(file, "borders-circles",
                        "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLUE "\" stroke-width=\"1\"");
        for (int i = 0; i < scene->n_circles; i++) {
            const Circle circle = scene->circles[i];
            svg_circle(file, circle.x * SCALE, circle.y * SCALE, circle.radius * SCALE, "");
        }
        svg_group_end(file);
    } else {
        svg_use(file, "borders-circles", 0, 0);
    }
    fputs("</svg>\n", file);
    for (int tile = 1; tile < COLUMNS; tile++) {
        const double x = left + tile * CIRCLE_TILE_SIDE * SCALE;
        svg_line(file, x, TOP, x, TOP + scene->height * SCALE,
                 "stroke=\"" SVG_GREY "\" stroke-dasharray=\"2 5\"");
    }
    for (int tile = 1; tile < ROWS; tile++) {
        const double y = TOP + tile * CIRCLE_TILE_SIDE * SCALE;
        svg_line(file, left, y, left + PANEL, y,
                 "stroke=\"" SVG_GREY "\" stroke-dasharray=\"2 5\"");
    }
    box_draw(file, left, all, "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
}

static const char PLANE_LOOK[] = "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"";

// The leaves of lab 02's tree. Returns how many of them the marked tile is in.
static int anywhere_draw(FILE *file, const Scene2D *scene, double left)
{
    KdTree2D tree;
    require(kdtree2d_build(scene->circles, (u32)scene->n_circles, LIMITS, &tree));
    const BBox2D marked = marked_box();
    int n_leaves = 0;
    for (u32 id = 0; id < tree.n_nodes; id++) {
        if (tree.nodes_flag[id] == LEAF) {
            const BBox2D box = tree.nodes_BBox[id];
            const BBox2D shown = {fmaxf(box.minX, 0), fminf(box.maxX, (float)scene->width),
                                  fmaxf(box.minY, 0), fminf(box.maxY, (float)scene->height)};
            box_draw(file, left, shown, PLANE_LOOK);
            n_leaves += box.minX < marked.maxX && box.maxX > marked.minX &&
                        box.minY < marked.maxY && box.maxY > marked.minY;
        }
    }
    tree2d_free(&tree);
    return n_leaves;
}

// The leaves of lab 10's tree below a node with a cell.
static void at_borders_draw(FILE *file, const CircleTree *tree, u32 id, BBox2D cell, double left)
{
    const TileNode node = tree->nodes[id];
    if (node.split_axis == KD_LEAF) {
        box_draw(file, left, cell, PLANE_LOOK);
        return;
    }
    BBox2D lower = cell, upper = cell;
    if (node.split_axis == 0) {
        lower.maxX = upper.minX = (float)node.split_pos;
    } else {
        lower.maxY = upper.minY = (float)node.split_pos;
    }
    at_borders_draw(file, tree, node.first, lower, left);
    at_borders_draw(file, tree, node.first + 1, upper, left);
}

void draw_borders(FILE *file, const Followed *followed)
{
    (void)followed;
    const double right = LEFT + PANEL + GAP, bottom = TOP + ROWS * CIRCLE_TILE_SIDE * SCALE + 30;
    const char *marked_look =
        "fill=\"" SVG_SAND "\" fill-opacity=\"0.7\" stroke=\"" SVG_ORANGE "\" stroke-width=\"5\"";
    Scene2D scene;
    CircleTree tree;
    require(scene2d_random(N_CIRCLES, SEED, 3, 12, COLUMNS * CIRCLE_TILE_SIDE,
                           ROWS * CIRCLE_TILE_SIDE, &scene));
    require(circle_tree_build(&scene, LIMITS, &tree));
    svg_begin(file, HEIGHT, "Planes anywhere, and planes only at the borders of tiles",
              "The same circles twice, on a dotted grid of tiles, one tile marked. Left they are "
              "cut by the tree of lab 02: its planes may be anywhere and cut the marked tile, "
              "which is in several leaves. Right by the tree of lab 10: each plane is on the "
              "border of tiles, and the marked tile is in one leaf.");
    svg_title(file, LEFT, 36, SVG_LEFT, "", "Lab 02: planes anywhere");
    svg_title(file, right, 36, SVG_LEFT, "", "Lab 10: only at the borders of tiles");
    scene_draw(file, &scene, LEFT);
    box_draw(file, LEFT, marked_box(), marked_look);
    svg_text(file, LEFT, bottom, SVG_LEFT, "", "The marked tile is in %d leaves.",
             anywhere_draw(file, &scene, LEFT));
    scene_draw(file, &scene, right);
    box_draw(file, right, marked_box(), marked_look);
    at_borders_draw(file, &tree, 0, (BBox2D){0, (float)scene.width, 0, (float)scene.height}, right);
    svg_text(file, right, bottom, SVG_LEFT, "", "One leaf: one descent for 256 pixels.");
    svg_text(file, LEFT, 68, SVG_LEFT, "fill=\"" SVG_GREY "\"", "dotted: tiles of 16 x 16 pixels");
    svg_end(file);
    circle_tree_free(&tree);
    scene2d_free(&scene);
}
