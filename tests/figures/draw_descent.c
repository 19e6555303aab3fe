// 03-descent.svg: the search for a pixel's leaf, a panel a step, as the kernel has recorded it.
#include "figures2d.h"

enum { TOP = 92, SIDE = 230, GAP = 26, MOST_PANELS = 4, HEIGHT = TOP + SIDE + 150 };

static void panel_draw(FILE *file, const Followed *followed, u32 i)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    const Step *step = followed_step(&followed->own, i);
    const int is_leaf = step->kind == STEP_LEAF;
    const double left = 16 + (double)i * (SIDE + GAP), y = TOP + SIDE + 34;
    const Plane2D plane = plane2d_at(followed, left, TOP, SIDE);
    plane2d_cell(file, &plane, tree->nodes_BBox[0], "fill=\"" SVG_PALE "\"");
    plane2d_cell(file, &plane, tree->nodes_BBox[step->id],
                 is_leaf ? "fill=\"" SVG_SAND "\"" : "fill=\"#ffffff\"");
    plane2d_circles(file, &plane, followed);
    plane2d_cell(file, &plane, tree->nodes_BBox[step->id],
                 "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"5\"");
    svg_title(file, left, TOP - 16, SVG_LEFT, "", "%u: %s %u", i, is_leaf ? "leaf" : "node",
              step->id);
    if (is_leaf) {
        const u32 *list = tree->mapNode2Circles + tree->nodes_Relations[step->id].circleMapOffset;
        svg_text(file, left, y, SVG_LEFT, "", "tests %u circles:", list[0]);
        for (u32 k = 1; k <= list[0]; k++) {
            const Step *test = followed_step(&followed->own, i + k);
            svg_text(file, left, y + 28 * k, SVG_LEFT, "", "%c: %s", circle_letter(test->id),
                     followed_is_hit(followed->world, test) ? "covers the pixel" : "does not");
        }
    } else {
        const NodeRel node = tree->nodes_Relations[step->id];
        const BBox2D box = tree->nodes_BBox[node.lChild];
        const int is_left = followed_step(&followed->own, i + 1)->id == node.lChild;
        plane2d_cell(file, &plane, box,
                     "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-dasharray=\"6 5\"");
        svg_text(file, left, y, SVG_LEFT, "", "in left child %u,", node.lChild);
        svg_text(file, left, y + 28, SVG_LEFT, "", "[%g, %g) x [%g, %g)?", box.minX, box.maxX,
                 box.minY, box.maxY);
        svg_text(file, left, y + 56, SVG_LEFT, "", is_left ? "yes: go to %u" : "no: go to %u",
                 is_left ? node.lChild : node.rChild);
    }
    plane2d_pixel(file, &plane, followed);
}

void draw_descent(FILE *file, const Followed *followed)
{
    svg_begin(
        file, HEIGHT, "The descent to leaf 13, step by step",
        "Four panels. The search for pixel 7, 7 goes from node 0, the whole square, to node 2, its "
        "right half, to node 6, the lower half of that, to leaf 13, a quarter. In each inner node "
        "the left child's cell is tested. In the leaf C covers the pixel and E does not.");
    svg_title(file, 16, 40, SVG_LEFT, "", "Pixel %d, %d: each step halves what is left",
              followed->x, followed->y);
    for (u32 i = 0; i < MOST_PANELS && followed_step(&followed->own, i)->kind <= STEP_LEAF; i++) {
        panel_draw(file, followed, i);
    }
    svg_end(file);
}
