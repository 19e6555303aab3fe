// Flying: how a view moves when keys and the mouse ask for it. Plain arithmetic, no window.
//
// Read next: world.h (Motion).
#ifndef FOLLOW_FLIGHT_H
#define FOLLOW_FLIGHT_H

#include "camera.h"
#include "scene3d.h"
#include "world.h"

// Move a view.
//   home     the scene's own view. Its length, from eye to `at`, sets the speed; its `up` stays the
//            window's `up`; its `at` is the middle that an orbit goes round
//   axes     the camera of `view`: only its right, up and forward count
//   motion   seconds of flight cover half the home view's length each; angles in radians
// First turns, then orbits, then flies. A view is never turned to less than 3 degrees from straight
// up or down, where `up` says nothing.
// Returns the new view.
View flight_move(const View *view, const View *home, const Camera *axes, Motion motion);

#endif
