// Lab 07: the part of a ray that is inside the scene's box.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by trace.cl.
#include "kdtree3d.h"
#include "ray.h"

// Clip a ray to a box: from where on, and up to where, is it inside?
//   t_min, t_max   in: the part of the ray that counts; out: its part inside the box
// Returns 1, or 0 if nothing is left: the ray misses the box, or the box is behind the eye.
// Source: lecture, slide "Sichtbarer Teil des Strahls".
int clip_to_box(BBox3D box, Ray ray, float *t_min, float *t_max)
{
    // TASK clip_to_box: on each axis the box is the space between two planes. The ray is inside
    // from the last of the three entries to the first of the three exits. A ray along the planes
    // has neither entry nor exit: it is between them all the way or never.
    //> (void)box, (void)ray, (void)t_min, (void)t_max;
    //> return 0;
    for (uint axis = 0; axis < 3; axis++) {
        const float origin = component(ray.origin, axis);
        const float direction = component(ray.direction, axis);
        if (direction == 0.0f) {
            if (origin < box.min[axis] || origin > box.max[axis]) {
                return 0;
            }
            continue;
        }
        const float t_low = (box.min[axis] - origin) / direction;
        const float t_high = (box.max[axis] - origin) / direction;
        *t_min = fmax(*t_min, fmin(t_low, t_high));
        *t_max = fmin(*t_max, fmax(t_low, t_high));
    }
    return *t_min <= *t_max;
    // END clip_to_box
}
