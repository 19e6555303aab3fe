// The plane of the lecture's example: its cells, circles and a pixel (see figures2d.h).
#include "figures2d.h"

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
