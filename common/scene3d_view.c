// Views: what a camera can be set up from (scene3d_fov() and its neighbours of scene3d.h).
//
// A camera and its rays are computed in float; what float cannot hold is found here, in double.
// Read next: camera.h.
#include "scene3d.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

// The sine of the smallest angle between the view and up. The camera's axes come from their cross
// product in float; rounding moves it by about 1e-7 and so turns the picture by 1e-7 / sine: by
// 0.001, half a pixel at the edge of a picture of 1000, where the sine is this small.
#define SMALLEST_SINE 1e-4

// A camera is set up in float: a cross product with an up of this length, or 1 / this length, must
// keep its digits.
#define LONGEST_VECTOR 1e32

// What is left of 0 by rounding in double, far above it and far below what counts.
#define ROUNDING 1e-12

f32 scene3d_fov(const View *view, int width, int height)
{
    const double half_angle = (double)view->angle / 2 * M_PI / 180;
    const int n_steps = height > 1 ? height - 1 : 1;  // from the top row's centre to the bottom's
    return (f32)(width * (2 * tan(half_angle) / n_steps));
}

// The distance from a float to the next, but never a denormal one: devices may take those for 0.
static double float_spacing(double value)
{
    const f32 magnitude = fabsf((f32)value);
    return fmax((double)nextafterf(magnitude, INFINITY) - magnitude, FLT_MIN);
}

// How far a step along `axis` must go from `forward` so that some coordinate becomes another float.
static double smallest_step(const double *forward, const double *axis)
{
    double smallest = INFINITY;
    for (int i = 0; i < 3; i++) {
        smallest = fmin(smallest, float_spacing(forward[i]) / fabs(axis[i]));
    }
    return smallest;
}

double scene3d_smallest_angle(const View *view, int height)
{
    const double up[3] = {view->up.x, view->up.y, view->up.z};
    double forward[3] = {(double)view->at.x - view->from.x, (double)view->at.y - view->from.y,
                         (double)view->at.z - view->from.z};
    const double length =
        sqrt(forward[0] * forward[0] + forward[1] * forward[1] + forward[2] * forward[2]);
    for (int i = 0; i < 3; i++) {
        forward[i] /= length;
    }
    // The two ways across: up without its part along forward; and the other by its size alone, as
    // for three directions at right angles the squares of each coordinate add up to 1.
    const double along = up[0] * forward[0] + up[1] * forward[1] + up[2] * forward[2];
    double upwards[3], sideways[3], upwards2 = 0;
    for (int i = 0; i < 3; i++) {
        upwards[i] = up[i] - along * forward[i];
        upwards2 += upwards[i] * upwards[i];
    }
    for (int i = 0; i < 3; i++) {
        upwards[i] /= sqrt(upwards2);
        const double rest = 1 - forward[i] * forward[i] - upwards[i] * upwards[i];
        sideways[i] = rest > ROUNDING ? sqrt(rest) : 0;
    }
    // A ray's direction is forward and some steps of a pixel's size to the right and up, in float.
    const double pixel_size =
        fmax(smallest_step(forward, sideways), smallest_step(forward, upwards));
    const int n_steps = height > 1 ? height - 1 : 1;
    return 2 * atan(pixel_size * n_steps / 2) * 180 / M_PI;
}

// In double no product of these overflows or becomes 0: floats go from 1e-45 to 3e38, and four of
// them are multiplied at most.
const char *scene3d_view_fault(const View *view)
{
    const double direction[3] = {(double)view->at.x - view->from.x,
                                 (double)view->at.y - view->from.y,
                                 (double)view->at.z - view->from.z};
    const double up[3] = {view->up.x, view->up.y, view->up.z};
    double direction2 = 0, up2 = 0, cross2 = 0;  // squared lengths
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const double cross = direction[i] * up[j] - direction[j] * up[i];
        direction2 += direction[i] * direction[i];
        up2 += up[i] * up[i];
        cross2 += cross * cross;
    }
    if (direction2 == 0) {
        return "the view's direction is zero (from is at)";
    }
    if (up2 == 0) {
        return "up is zero";
    }
    const double longest2 = LONGEST_VECTOR * LONGEST_VECTOR;
    if (direction2 * longest2 < 1 || direction2 > longest2 || up2 * longest2 < 1 ||
        up2 > longest2) {
        return "the view's direction or up is too short or too long (1e-32 to 1e32)";
    }
    if (cross2 < SMALLEST_SINE * SMALLEST_SINE * direction2 * up2) {
        return "up is parallel to the view";
    }
    return NULL;
}
