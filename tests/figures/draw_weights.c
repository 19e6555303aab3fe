// 08-weights.svg: lab 08's question in two dimensions. The trees that three rules grow over the
// same circles, and what a pixel is expected to do in each.
#include "figures2d.h"
#include "plane_trees.h"

#include "lab.h"

// A panel has a scene and a tree; a row has one scene, a column one rule. Pixels.
enum { N_COLUMNS = 3, LEFT = 16, PANEL = 320, GAP = 16, TOP = 108, ROW = 316, HEIGHT = 736 };

static const struct Column {
    PlaneRule rule;
    const char *title;
} COLUMNS[N_COLUMNS] = {
    {{NO_WEIGHT, NO_WEIGHT}, "the middle, 8 a leaf"},
    {{AREA, AREA}, "cost by area"},
    {{PERIMETER, PERIMETER}, "cost by perimeter"},
};

// Pixels of the figure for one of the scene.
static double scale_of(BBox2D root)
{
    return PANEL / ((double)root.maxX - root.minX);
}

// The circles of a row, in its first panel; svg_use() draws them in the others.
static void circles_draw(FILE *file, const char *id, const Scene2D *scene, BBox2D root, double top)
{
    const double scale = scale_of(root);
    svg_group_begin(file, id, "fill=\"" SVG_SKY "\" stroke=\"" SVG_BLUE "\" stroke-width=\"0.5\"");
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle circle = scene->circles[i];
        svg_circle(file, LEFT + (circle.x - root.minX) * scale,
                   top + (circle.y - root.minY) * scale, circle.radius * scale, "");
    }
    svg_group_end(file);
}

static void leaves_draw(FILE *file, const PlaneTree *tree, double left, double top)
{
    const double scale = scale_of(tree->root);
    svg_boxes_begin(file, "fill=\"none\" stroke=\"" SVG_BLACK "\"");
    for (u32 i = 0; i < tree->n_leaves; i++) {
        const BBox2D cell = tree->leaves[i];
        svg_boxes_add(file, left + (cell.minX - tree->root.minX) * scale,
                      top + (cell.minY - tree->root.minY) * scale,
                      ((double)cell.maxX - cell.minX) * scale,
                      ((double)cell.maxY - cell.minY) * scale);
    }
    svg_boxes_end(file);
}

static void row_draw(FILE *file, const char *id, const Scene2D *scene, double top)
{
    for (int i = 0; i < N_COLUMNS; i++) {
        const double left = LEFT + i * (PANEL + GAP);
        PlaneTree tree = plane_tree_grow(scene, COLUMNS[i].rule);
        const double bottom = top + ((double)tree.root.maxY - tree.root.minY) * scale_of(tree.root);
        if (i == 0) {
            circles_draw(file, id, scene, tree.root, top);
        } else {
            svg_use(file, id, left - LEFT, 0);
        }
        leaves_draw(file, &tree, left, top);
        svg_text(file, left + PANEL / 2.0, bottom + 26, SVG_MIDDLE, "",
                 "%.1f steps + %.1f tests = %.1f", tree.steps, tree.tests, tree.steps + tree.tests);
        plane_tree_free(&tree);
    }
}

void draw_weights(FILE *file, const Followed *followed)
{
    (void)followed;
    Scene2D random, clusters;
    require(plane_scene_random(&random));
    require(plane_scene_clusters(&clusters));
    svg_begin(file, HEIGHT, "Three trees over the same circles",
              "Above 500 circles that are strewn evenly, below 500 in ten clusters. Each is cut "
              "three times: in the left picture halved until 8 circles are left, in the second "
              "one where it costs least with the area as weight, in the right one with the "
              "perimeter. Below each: how many steps and tests a pixel is expected to take.");
    svg_title(file, LEFT, 36, SVG_LEFT, "", "A pixel is a point: its weight is the area");
    for (int i = 0; i < N_COLUMNS; i++) {
        svg_text(file, LEFT + i * (PANEL + GAP) + PANEL / 2.0, TOP - 18, SVG_MIDDLE, "", "%s",
                 COLUMNS[i].title);
    }
    row_draw(file, "weights-random", &random, TOP);
    row_draw(file, "weights-clusters", &clusters, TOP + ROW);
    svg_end(file);
    scene2d_free(&random);
    scene2d_free(&clusters);
}
