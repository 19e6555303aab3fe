// Lab 04: from a view (eye, look-at, up, angle) to the camera that the kernels use.
//
// Flow: SCENE -> BUFFERS (the camera is an argument of the kernel) -> kernel -> image ->
// comparison. Called by main.c. Read next: primary_ray.cl.
#include "camera_from_view.h"

void camera_axes(View view, Vec3 *right, Vec3 *up, Vec3 *forward)
{
    // TASK camera_axes: forward goes from the eye to the point looked at. right is at right angles
    // to forward and view.up; up is at right angles to right and forward. vec3_cross is
    // right-handed, so the order of its factors matters.
    //> (void)view;
    //> *right = (Vec3){1, 0, 0};
    //> *up = (Vec3){0, 1, 0};
    //> *forward = (Vec3){0, 0, -1};
    *forward = vec3_normalized(vec3_minus(view.at, view.from));
    *right = vec3_normalized(vec3_cross(*forward, view.up));
    *up = vec3_cross(*right, *forward);
    // END camera_axes
}

Camera camera_from_view(View view, int width, int height)
{
    Camera camera = {.eye = view.from, .fov = scene3d_fov(&view, width, height)};
    camera_axes(view, &camera.right, &camera.up, &camera.forward);
    return camera;
}
