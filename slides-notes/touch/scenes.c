// Opening scenes in a page: those that are made. There are no files.
//
// Read next: scene2d_open.c and scene3d_open.c, in whose place this stands.
#include "scene2d.h"
#include "scene3d.h"

int scene2d_open(const char *name, int width, int height, Scene2D *scene)
{
    return scene2d_generate(name, width, height, scene);
}

int scene3d_open(const char *name, int width, int height, Scene3D *scene)
{
    return scene3d_generate(name, width, height, scene);
}
