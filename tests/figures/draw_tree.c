// 02-tree.svg: the cells of the lecture's example, and the tree beside them.
#include "figures2d.h"

// Where the tree stands. Pixels.
enum { PLANE_TOP = 88, TREE_LEFT = 520, TREE_RIGHT = 1012, FIRST_LEVEL = 112, LEVEL = 96 };
enum { HEIGHT = 540 };

// A node's level, from its parents, and how many nodes of that level stand left of it.
typedef struct Place {
    int level, number;
} Place;

// The tree of the example is full: node ids of level n begin with 2^(n-1) - 1.
static Place place_of(u32 id)
{
    int level = 1;
    while (id + 1 >= 1u << level) {
        level++;
    }
    return (Place){level, (int)(id + 1 - (1u << (level - 1)))};
}

double tree2d_x(u32 id)
{
    const Place place = place_of(id);
    return TREE_LEFT + (place.number + 0.5) * (TREE_RIGHT - TREE_LEFT) / (1 << (place.level - 1));
}

double tree2d_y(u32 id)
{
    return FIRST_LEVEL + (place_of(id).level - 1) * LEVEL;
}

static void leaf_draw(FILE *file, const KdTree2D *tree, u32 id, int is_marked)
{
    svg_box(file, tree2d_x(id) - 24, tree2d_y(id) - 20, 48, 40,
            is_marked ? "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"5\""
                      : "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
    char letters[16] = "";
    const u32 *list = tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
    for (u32 i = 1; i <= list[0] && i < sizeof letters; i++) {
        letters[i - 1] = circle_letter(list[i]);
    }
    svg_text(file, tree2d_x(id), tree2d_y(id) + 46, SVG_MIDDLE, "", "%s", letters);
}

void tree2d_nodes(FILE *file, const KdTree2D *tree, u32 marked)
{
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == INNER) {
            const u32 children[] = {tree->nodes_Relations[id].lChild,
                                    tree->nodes_Relations[id].rChild};
            for (int i = 0; i < 2; i++) {
                svg_line(file, tree2d_x(id), tree2d_y(id), tree2d_x(children[i]),
                         tree2d_y(children[i]), "stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
            }
        }
    }
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == INNER) {
            svg_circle(file, tree2d_x(id), tree2d_y(id), 20,
                       "fill=\"" SVG_PALE "\" stroke=\"" SVG_BLACK "\" stroke-width=\"2\"");
        } else {
            leaf_draw(file, tree, id, id == marked);
        }
        svg_text(file, tree2d_x(id), tree2d_y(id) + 7, SVG_MIDDLE, "", "%u", id);
    }
}

static void plane_draw(FILE *file, const Followed *followed, const KdTree2D *tree, u32 marked)
{
    const Plane2D plane = plane2d_at(followed, 40, PLANE_TOP, 400);
    const BBox2D root = tree->nodes_BBox[0], leaf = tree->nodes_BBox[marked];
    plane2d_cell(file, &plane, leaf, "fill=\"" SVG_SAND "\"");
    plane2d_circles(file, &plane, followed);
    plane2d_cell(file, &plane, leaf, "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"5\"");
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == LEAF) {
            const BBox2D box = tree->nodes_BBox[id];
            plane2d_cell(file, &plane, box, "fill=\"none\" stroke=\"" SVG_BLACK "\"");
            svg_text(file, plane2d_x(&plane, box.minX) + 6, plane2d_y(&plane, box.minY) + 22,
                     SVG_LEFT, "", "%u", id);
        }
    }
    plane2d_pixel(file, &plane, followed);
    plane2d_letters(file, &plane, followed);
    const f32 marks[] = {root.minX, leaf.minX, leaf.maxX, root.maxX};
    for (int i = 0; i < 4; i++) {
        svg_text(file, plane2d_x(&plane, marks[i]), PLANE_TOP + 426, SVG_MIDDLE, "", "%g",
                 marks[i]);
    }
    svg_text(file, 34, plane2d_y(&plane, root.minY) + 16, SVG_RIGHT, "", "%g", root.minY);
    svg_text(file, 34, plane2d_y(&plane, leaf.minY) + 7, SVG_RIGHT, "", "%g", leaf.minY);
    svg_text(file, 34, plane2d_y(&plane, root.maxY), SVG_RIGHT, "", "%g", root.maxY);
}

void draw_tree(FILE *file, const Followed *followed)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    const u32 marked = followed_leaf(followed);
    svg_begin(
        file, HEIGHT, "The worked example: cells and tree",
        "Left: five circles A to E in a square from 0 to 10, cut into eight cells, the leaves 7 to "
        "14. Right: the tree, nodes 0 to 14 on four levels, with the circles of each leaf. Leaf 13 "
        "is marked in both; a cross in it is pixel 7, 7.");
    svg_title(file, 40, 40, SVG_LEFT, "", "Eight cells");
    svg_title(file, TREE_LEFT - 4, 40, SVG_LEFT, "", "The tree: pixel %d, %d is in leaf %u",
              followed->x, followed->y, marked);
    plane_draw(file, followed, tree, marked);
    tree2d_nodes(file, tree, marked);
    for (int level = 1; level <= followed->world->figures.depth; level++) {
        svg_text(file, TREE_LEFT - 60, FIRST_LEVEL + (level - 1) * LEVEL - 24, SVG_LEFT,
                 "fill=\"" SVG_GREY "\"", "level %d", level);
    }
    svg_end(file);
}
