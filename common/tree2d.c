// Releasing the 2D kd-tree's arrays; who fills them is solutions/02-kdtree-2d-build/kdtree2d_build.c.
#include "tree2d.h"

#include <stdlib.h>

void tree2d_free(KdTree2D *tree)
{
    free(tree->nodes_Relations);
    free(tree->nodes_flag);
    free(tree->nodes_BBox);
    free(tree->mapNode2Circles);
    *tree = (KdTree2D){0};
}
