// Drawing a 2D kd-tree: its leaf cells over the circles, as pixels and as SVG.
//
// The picture that lab 02 makes. Read next: image.h, where it is saved.
#ifndef COMMON_TREE2D_DRAW_H
#define COMMON_TREE2D_DRAW_H

#include "image.h"
#include "scene2d.h"
#include "tree2d.h"

#include <stdio.h>

// Draw circles and cell borders into a new picture of the scene's size, small scenes magnified by
// the largest whole factor that keeps the longer side within 640 pixels. Any tree may be drawn, a
// student's broken one too: what is not finite or lies outside is left out. Returns 0, or -1 after
// one message on stderr. Release with image_free().
int tree2d_draw(const Scene2D *scene, const KdTree2D *tree, Image *image);

// Write the same as an <svg> element, cells labelled with their node ids where they are large
// enough. Returns 0, or -1: after one message on stderr when memory runs out, and without one when
// writing failed, which ferror(file) tells.
int tree2d_write_svg(FILE *file, const Scene2D *scene, const KdTree2D *tree);

#endif
