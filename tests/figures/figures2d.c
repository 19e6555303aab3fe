// The figures of the first half: the lecture's example, and the search for pixel 7, 7.
//
//     figures2d FOLDER
#include "figures2d.h"

#include "complain.h"

Plane2D plane2d_at(const Followed *followed, double left, double top, double side)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    return (Plane2D){left, top, side, tree->nodes_BBox[0]};
}

double plane2d_x(const Plane2D *plane, double x)
{
    return plane->left +
           (x - plane->root.minX) * plane->side / ((double)plane->root.maxX - plane->root.minX);
}

double plane2d_y(const Plane2D *plane, double y)
{
    return plane->top +
           (y - plane->root.minY) * plane->side / ((double)plane->root.maxX - plane->root.minX);
}

void plane2d_cell(FILE *file, const Plane2D *plane, BBox2D box, const char *look)
{
    const double left = plane2d_x(plane, box.minX), top = plane2d_y(plane, box.minY);
    svg_box(file, left, top, plane2d_x(plane, box.maxX) - left, plane2d_y(plane, box.maxY) - top,
            look);
}

char circle_letter(u32 id)
{
    return (char)('A' + id);
}

void plane2d_circles(FILE *file, const Plane2D *plane, const Followed *followed)
{
    const Circle *circles = followed->world->kind->data(followed->world).circles;
    for (int id = 0; id < followed->world->n_elements; id++) {
        const double x = plane2d_x(plane, circles[id].x), y = plane2d_y(plane, circles[id].y);
        svg_circle(file, x, y, plane2d_x(plane, circles[id].x + circles[id].radius) - x,
                   "fill=\"" SVG_SKY "\" fill-opacity=\"0.6\" stroke=\"" SVG_BLUE
                   "\" stroke-width=\"2\"");
    }
}

void plane2d_letters(FILE *file, const Plane2D *plane, const Followed *followed)
{
    const Circle *circles = followed->world->kind->data(followed->world).circles;
    for (int id = 0; id < followed->world->n_elements; id++) {
        svg_title(file, plane2d_x(plane, circles[id].x), plane2d_y(plane, circles[id].y) + 8,
                  SVG_MIDDLE, SVG_HALO, "%c", circle_letter((u32)id));
    }
}

void plane2d_pixel(FILE *file, const Plane2D *plane, const Followed *followed)
{
    svg_cross(file, plane2d_x(plane, followed->x), plane2d_y(plane, followed->y), 8,
              "stroke=\"" SVG_ORANGE "\" stroke-width=\"4\"");
}

u32 followed_leaf(const Followed *followed)
{
    return followed->own.steps[steps_kept(followed->own.n_steps) - 1].id;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        complain("usage: figures2d FOLDER");
        return EXIT_FAILURE;
    }
    char *options[] = {argv[0],       "--scene", "example", "--max-depth", "4",
                       "--leaf-size", "1",       "--pixel", "7,7",         NULL};
    static const Figure FIGURES[] = {
        {"00-work-groups.svg", draw_groups}, {"01-sample-point.svg", draw_sample},
        {"02-tree.svg", draw_tree},          {"02-arrays.svg", draw_arrays},
        {"03-descent.svg", draw_descent},    {NULL, NULL},
    };
    figures_draw(argv[1], options, FIGURES);
    return EXIT_SUCCESS;
}
