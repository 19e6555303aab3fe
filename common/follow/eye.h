// What worlds in 3D have in common: an eye that flies. Their pose is the scene's view.
//
// Read next: flight.h, spheres.c.
#ifndef FOLLOW_EYE_H
#define FOLLOW_EYE_H

#include "scene3d.h"
#include "world.h"

// Look at a scene from where it wants to be seen. Sets the world's scene, size, pose and home.
//   scene   of the world; lives as long as it does
void eye_open(World *world, Scene3D *scene);

// place(), move() and film_pose() of a WorldKind. The film goes once round the scene's middle.
int eye_place(World *world);
void eye_move(World *world, Motion motion);
Pose eye_film_pose(const World *world, int frame, int n_frames);

#endif
