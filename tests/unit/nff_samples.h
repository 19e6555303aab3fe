// Texts in the Neutral File Format, and reading them, for the tests of its reader.
#ifndef UNIT_NFF_SAMPLES_H
#define UNIT_NFF_SAMPLES_H

#define SCENE_NAME "scene.nff"
#include "scene3d_nff.h"
#include "scene_texts.h"

#define VIEW "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 512 256\n"
#define SPHERE "s 1 -2.5 3 0.5\n"

static inline int are_equal(Vec3 v, float x, float y, float z)
{
    return v.x == x && v.y == y && v.z == z;
}

#endif
