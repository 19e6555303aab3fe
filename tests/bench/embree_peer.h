// The peer of the 3D bench: Embree, Intel's ray tracing library, on the same spheres, camera,
// lights and number of threads. Built where its package is installed (libembree-dev); version 3
// and 4.
//
// Read next: bench3d.c.
#ifndef BENCH_EMBREE_PEER_H
#define BENCH_EMBREE_PEER_H

#include "image.h"
#include "scene3d.h"
#include "secondary_ray.h"

// No sphere is hit: ray.h's, which only the device sees.
#define NO_SPHERE 0xffffffffu

typedef struct EmbreePeer EmbreePeer;

// The calls: of one ray; of a packet of 4, 8 or 16; of a stream. rtcIntersect... find the first
// hit, rtcOccluded... whether there is any.
typedef enum EmbreeCall {
    EMBREE_1,       // rtcIntersect1, rtcOccluded1
    EMBREE_4,       // rtcIntersect4 ...
    EMBREE_8,       // rtcIntersect8
    EMBREE_16,      // rtcIntersect16
    EMBREE_STREAM,  // rtcIntersect1M; Embree 4 has none
    N_EMBREE_CALLS,
} EmbreeCall;

// Is the call there in the version this was built with?
int embree_peer_has(EmbreeCall call);

// The version of Embree this was built with, "3.13.5"; or NULL when it was built without.
const char *embree_peer_version(void);

// Hand a scene to Embree and let it build its tree with n_threads threads.
//   build_ms   out: how long that took
// Returns it, or NULL after one message on stderr. Release with embree_peer_free().
EmbreePeer *embree_peer_new(const Scene3D *scene, int n_threads, double *build_ms);
void embree_peer_free(EmbreePeer *peer);

// Draw the scene with one of the calls that are there, on the same threads, shaded as lab 05 does.
// The rays of a packet or stream are those of a small square of pixels.
//   image   of the scene's size; width and height are multiples of 8
void embree_peer_draw(const EmbreePeer *peer, EmbreeCall call, Image *image);

// What is asked of rays that begin on a surface.
typedef enum RayKind {
    SHADOW_RAYS,    // does anything stand in the way? 1, or 0
    MIRRORED_RAYS,  // which sphere comes first? its number, or NO_SPHERE
    N_RAY_KINDS,
} RayKind;

// Search rays with one of the calls that are there, on the same threads; a packet or stream holds
// rays that stand one behind the other.
//   answers[n_rays]   out
void embree_peer_search(const EmbreePeer *peer, EmbreeCall call, RayKind kind,
                        const SecondaryRay *rays, int n_rays, u32 *answers);

#endif
