// Drawing a cut through a 3D kd-tree: the cells of its leaves, and the spheres cut open.
//
// The picture that lab 06 makes. Read next: image.h, where it is saved.
#ifndef COMMON_TREE3D_DRAW_H
#define COMMON_TREE3D_DRAW_H

#include "image.h"
#include "scene3d.h"
#include "tree3d.h"

// Draw the cut through the middle of the scene's box (where no sphere is there, as between two
// layers of a lattice, through the nearest sphere's centre) at right angles to its shortest side (y
// before z before x where equal) into a new picture of the scene's size: the brighter a cell, the
// more spheres its leaf holds; where the cut meets a sphere, its circle in the sphere's colour. The
// tree must have passed tree3d_check(). Returns 0, or -1 after one message on stderr. Release with
// image_free().
int tree3d_draw(const Scene3D *scene, const KdTree3D *tree, Image *image);

#endif
