// The peer of the 3D bench: Embree, Intel's ray tracing library, on the same spheres, camera,
// lights and number of threads. Built where its package is installed (libembree-dev); version 3
// and 4.
//
// Read next: bench3d.c.
#ifndef BENCH_EMBREE_PEER_H
#define BENCH_EMBREE_PEER_H

#include "image.h"
#include "scene3d.h"

typedef struct EmbreePeer EmbreePeer;

// The version of Embree this was built with, "3.13.5"; or NULL when it was built without.
const char *embree_peer_version(void);

// Hand a scene to Embree and let it build its tree with n_threads threads.
//   build_ms   out: how long that took
// Returns it, or NULL after one message on stderr. Release with embree_peer_free().
EmbreePeer *embree_peer_new(const Scene3D *scene, int n_threads, double *build_ms);
void embree_peer_free(EmbreePeer *peer);

// Draw the scene with rtcIntersect1, one ray at a time, on the same threads, shaded as lab 05 does.
//   image   of the scene's size
void embree_peer_draw(EmbreePeer *peer, Image *image);

#endif
