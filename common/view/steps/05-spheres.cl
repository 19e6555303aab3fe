// Lab 05's kernel, writing down the steps of a ray (steps.h).
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Started by record.c.
#include "spheres.h"

#include "render_spheres.cl"
