// The eye of worlds in 3D (see eye.h). The camera is lab 04's.
//
// Called by spheres.c and rays.c.
#include "eye.h"

#include "camera_from_view.h"
#include "flight.h"

#include <math.h>

static Pose pose_of(const View *view)
{
    return (Pose){{view->from.x, view->from.y, view->from.z, view->at.x, view->at.y, view->at.z,
                   view->up.x, view->up.y, view->up.z}};
}

// The scene's view, seen from another place.
static View view_of(const World *world, Pose pose)
{
    const f32 *n = pose.numbers;
    View view = world->scene3d->view;
    view.from = (Vec3){n[0], n[1], n[2]};
    view.at = (Vec3){n[3], n[4], n[5]};
    view.up = (Vec3){n[6], n[7], n[8]};
    return view;
}

void eye_open(World *world, Scene3D *scene)
{
    world->scene3d = scene;
    world->width = scene->width;
    world->height = scene->height;
    world->home = world->pose = pose_of(&scene->view);
}

int eye_place(World *world)
{
    world->scene3d->view = view_of(world, world->pose);
    return 0;
}

void eye_move(World *world, Motion motion)
{
    const View home = view_of(world, world->home);
    const View view = view_of(world, world->pose);
    const Camera axes = camera_from_view(view, world->width, world->height);
    const View moved = flight_move(&view, &home, &axes, motion);
    // A view from which no camera can be set up is not gone to.
    if (scene3d_view_fault(&moved) == NULL) {
        world->pose = pose_of(&moved);
    }
}

Pose eye_film_pose(const World *world, int frame, int n_frames)
{
    const View home = view_of(world, world->home);
    const Camera axes = camera_from_view(home, world->width, world->height);
    const Motion round = {.orbit_right = (f32)(2 * M_PI * frame / n_frames)};
    const View view = flight_move(&home, &home, &axes, round);
    return pose_of(&view);
}
