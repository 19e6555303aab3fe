// The figures of the first half: what they share.
#ifndef TESTS_FIGURES2D_H
#define TESTS_FIGURES2D_H

#include "figures.h"

// The lecture's example drawn at a place: x, y of its top left corner, and how wide it is.
typedef struct Plane2D {
    double left, top, side;
    BBox2D root;
} Plane2D;

Plane2D plane2d_at(const Followed *followed, double left, double top, double side);
double plane2d_x(const Plane2D *plane, double x);
double plane2d_y(const Plane2D *plane, double y);

// A node's cell.
void plane2d_cell(FILE *file, const Plane2D *plane, BBox2D box, const char *look);

// The circles; and, above whatever was drawn since, their letters.
void plane2d_circles(FILE *file, const Plane2D *plane, const Followed *followed);
void plane2d_letters(FILE *file, const Plane2D *plane, const Followed *followed);

// The pixel that is followed: a cross.
void plane2d_pixel(FILE *file, const Plane2D *plane, const Followed *followed);

// What the lecture calls circle `id`: 'A' and on.
char circle_letter(u32 id);

// The node that the followed pixel ends in.
u32 followed_leaf(const Followed *followed);

void draw_tree(FILE *file, const Followed *followed);     // 02-tree.svg
void draw_arrays(FILE *file, const Followed *followed);   // 02-arrays.svg
void draw_descent(FILE *file, const Followed *followed);  // 03-descent.svg
void draw_sample(FILE *file, const Followed *followed);   // 01-sample-point.svg
void draw_groups(FILE *file, const Followed *followed);   // 00-work-groups.svg

#endif
