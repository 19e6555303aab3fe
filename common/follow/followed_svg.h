// The pictures of a followed pixel: a ray's way along t, step by step; a pixel's cells.
//
// Read next: ray_svg.c.
#ifndef FOLLOW_FOLLOWED_SVG_H
#define FOLLOW_FOLLOWED_SVG_H

#include "followed.h"
#include "svg.h"

// In 3D: a row a step. From left to right goes t; a bar is the node's part of the ray, behind it
// lie the parts of the nodes that wait.
void ray_svg(const Followed *followed, FILE *file);

// In 2D: the cells on the way down, the pixel, and the circles of its leaf.
void cell_svg(const Followed *followed, FILE *file);

#endif
