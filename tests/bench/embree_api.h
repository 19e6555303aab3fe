// Embree itself, for the files that call it: what its versions 3 and 4 name differently, and what
// stands behind an EmbreePeer.
//
// Included by embree_peer.c and embree_rays.c where Embree is installed.
#ifndef BENCH_EMBREE_API_H
#define BENCH_EMBREE_API_H

#include "camera_from_view.h"
#include "embree_peer.h"

#if WITH_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

struct EmbreePeer {
    const Scene3D *scene;
    Camera camera;
    int n_threads;
    RTCDevice device;
    RTCScene embree_scene;
};

// Run a function on all of the peer's threads, this one among them, and wait for all.
void embree_peer_run(const EmbreePeer *peer, void *work(void *shared), void *shared);

// What a call for the nearest hit is told of its rays, and one for any hit; and where among its
// arguments. COHERENT rays lie close together, INCOHERENT ones go in all directions.
#if WITH_EMBREE == 4
typedef struct RTCIntersectArguments NearestHints;
typedef struct RTCOccludedArguments AnyHints;
#define INIT_NEAREST rtcInitIntersectArguments
#define INIT_ANY rtcInitOccludedArguments
#define COHERENT RTC_RAY_QUERY_FLAG_COHERENT
#define INCOHERENT RTC_RAY_QUERY_FLAG_INCOHERENT
#define ARGUMENTS(peer, hints, query) (peer)->embree_scene, query, hints
#else
typedef struct RTCIntersectContext NearestHints;
typedef struct RTCIntersectContext AnyHints;
#define INIT_NEAREST rtcInitIntersectContext
#define INIT_ANY rtcInitIntersectContext
#define COHERENT RTC_INTERSECT_CONTEXT_FLAG_COHERENT
#define INCOHERENT RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
#define ARGUMENTS(peer, hints, query) (peer)->embree_scene, hints, query
#endif

static inline NearestHints nearest_hints(int flags)
{
    NearestHints hints;
    INIT_NEAREST(&hints);
    hints.flags = flags;
    return hints;
}

static inline AnyHints any_hints(int flags)
{
    AnyHints hints;
    INIT_ANY(&hints);
    hints.flags = flags;
    return hints;
}

#endif
