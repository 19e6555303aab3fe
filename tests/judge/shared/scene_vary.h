// Scenes that have a name, rolled anew for each seed: reports that were handed back show much of a
// job, and no table of what they show may earn anything with another one. What a scene is there
// for stays: what touches, overlaps, is equal or lies at a border does so afterwards.
#ifndef JUDGE_SCENE_VARY_H
#define JUDGE_SCENE_VARY_H

#include "random.h"
#include "scene2d.h"
#include "scene3d.h"

// A picture's side of n pixels, or up to a sixth less. What is even or odd stays so.
int side_vary(Random *random, int n);

// Mirror and turn a scene as a whole, each of the eight ways as likely.
void scene2d_turn(Scene2D *scene, Random *random);

// Give all circles other colours, none of them black.
void scene2d_recolour(Scene2D *scene, Random *random);

// All of it: turn the scene, recolour it, and change circles' ids and depths. Of two circles the
// nearer one stays so, and of two that are equally near the one with the lower id. For scenes of up
// to SCENE2D_EDGE_CASE_CIRCLES.
void scene2d_vary(Scene2D *scene, Random *random);

// Change the spheres' ids and what they look like, the colours of the lights, and by a few per cent
// how far the view reaches.
void scene3d_vary(Scene3D *scene, Random *random);

#endif
