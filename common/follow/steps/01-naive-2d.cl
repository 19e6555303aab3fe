// Lab 01's kernel, writing down the steps of a pixel (steps.h).
//
// Started by record.c.
#include "circles.h"
#define work_save(work, x, y, width, d_work) steps_save(&work, x, y, color, NO_ID, d_work)

#include "implicit2DRenderer.cl"
