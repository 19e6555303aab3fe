// Lab 05's kernel, writing down the steps of a ray (steps.h).
//
// Started by record.c.
#include "spheres.h"
#define work_save(work, x, y, width, d_work) steps_save(&work, ray, hit, d_work)

#include "render_spheres.cl"
