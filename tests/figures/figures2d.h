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

// The tree of the example beside the plane: where a node stands; and all of them, with the letters
// of the leaves' circles, one leaf marked or, with NO_ID, none.
double tree2d_x(u32 id);
double tree2d_y(u32 id);
void tree2d_nodes(FILE *file, const KdTree2D *tree, u32 marked);

// What the lecture calls circle `id`: 'A' and on.
char circle_letter(u32 id);

// The node that the followed pixel ends in.
u32 followed_leaf(const Followed *followed);

void draw_tree(FILE *file, const Followed *followed);     // 02-tree.svg
void draw_arrays(FILE *file, const Followed *followed);   // 02-arrays.svg
void draw_descent(FILE *file, const Followed *followed);  // 03-descent.svg
void draw_search(FILE *file, const Followed *followed);   // 03-search.svg
void draw_sample(FILE *file, const Followed *followed);   // 01-sample-point.svg
void draw_groups(FILE *file, const Followed *followed);   // 00-work-groups.svg
void draw_host(FILE *file, const Followed *followed);     // 00-host-device.svg
void draw_failed(FILE *file, const Followed *followed);   // 02-failed-split.svg
void draw_weights(FILE *file, const Followed *followed);  // 08-weights.svg
void draw_borders(FILE *file, const Followed *followed);  // 10-borders.svg

// 03-search.svg at another step, which a reader can take forward and back. Narrow, it has the tree
// below the plane.
void draw_search_step(FILE *file, const Followed *followed, u32 step, FigureShape shape);

// Where in the scene a point of that drawing is.
void search_point(const Followed *followed, double x, double y, double *scene_x, double *scene_y);

// That step in words, a line or a few.
void search_step_tell(FILE *file, const Followed *followed, u32 step);

#endif
