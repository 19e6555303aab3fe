// Setting up the camera from a scene's view. Task of lab 04; labs 05 and 07 call it
// (scene_buffers.c).
// Source: lecture, slide "Viewing".
#ifndef CAMERA_FROM_VIEW_H
#define CAMERA_FROM_VIEW_H

#include "camera.h"
#include "scene3d.h"

// The camera's three axes for a view (see camera.h): unit vectors at right angles to each other.
//   view   its direction and its `up` are not zero and not parallel; they may have any length,
//          such as 1e-20 or 1e20
//   right, up, forward   out
void camera_axes(View view, Vec3 *right, Vec3 *up, Vec3 *forward);

// The camera for a view and a picture of width x height pixels.
Camera camera_from_view(View view, int width, int height);

#endif
