// Flying (see flight.h). A view is three points in space: every motion turns or shifts them.
//
// Called by spheres.c.
#include "flight.h"

#include <math.h>

// Home lengths a second of flight covers, and a notch of the wheel.
static const f32 LENGTHS_A_SECOND = 0.5f;
static const f32 LENGTHS_A_NOTCH = 0.05f;

// Straight up and down `up` does not say how the picture is turned. The cosine of 3 degrees.
static const double STEEPEST = 0.9986;

static Vec3 plus(Vec3 a, Vec3 b)
{
    return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

// Turn v about a unit axis, right-handed: with the axis towards one, against the clock. Rodrigues'
// formula.
static Vec3 turned(Vec3 v, Vec3 axis, f32 angle)
{
    const f32 cosine = cosf(angle);
    const Vec3 across = vec3_scaled(vec3_cross(axis, v), sinf(angle));
    const Vec3 along = vec3_scaled(axis, vec3_dot(axis, v) * (1 - cosine));
    return plus(plus(vec3_scaled(v, cosine), across), along);
}

// Turn v by two angles: about `up`, and about `right` unless that leads to the poles.
static Vec3 looked(Vec3 v, Vec3 up, Vec3 right, f32 about_up, f32 about_right, Vec3 forward)
{
    const double steepness = fabs((double)vec3_dot(turned(forward, right, about_right), up));
    const double steepest = fmax(STEEPEST, fabs((double)vec3_dot(forward, up)));
    const f32 pitch = steepness <= steepest ? about_right : 0;
    return turned(turned(v, right, pitch), up, about_up);
}

View flight_move(const View *view, const View *home, const Camera *axes, Motion motion)
{
    View moved = *view;
    const Vec3 up = vec3_normalized(home->up);
    moved.up = home->up;

    // Turning to the right is with the clock, seen from above.
    const Vec3 sight = vec3_minus(view->at, view->from);
    moved.at = plus(moved.from, looked(sight, up, axes->right, -motion.turn_right, motion.turn_up,
                                       axes->forward));

    // An eye that goes to the right round the middle turns to the left; one that goes up looks
    // down. Both ends of the sight turn alike, so the middle stays where it is in the picture.
    if (motion.orbit_right != 0 || motion.orbit_up != 0) {
        const Vec3 ends[2] = {moved.from, moved.at};
        Vec3 round[2];
        for (int i = 0; i < 2; i++) {
            round[i] = plus(home->at, looked(vec3_minus(ends[i], home->at), up, axes->right,
                                             motion.orbit_right, -motion.orbit_up, axes->forward));
        }
        moved.from = round[0];
        moved.at = round[1];
    }

    const f32 length = (f32)vec3_length(vec3_minus(home->at, home->from));
    const f32 second = LENGTHS_A_SECOND * length;
    const f32 forward = second * motion.forward + LENGTHS_A_NOTCH * length * (f32)motion.notches;
    const Vec3 step = plus(plus(vec3_scaled(axes->right, second * motion.right),
                                vec3_scaled(axes->up, second * motion.up)),
                           vec3_scaled(axes->forward, forward));
    moved.from = plus(moved.from, step);
    moved.at = plus(moved.at, step);
    return moved;
}
