// What the 3D bench measures besides pictures: lab 09's shadow rays, and its first mirrored ones,
// of one scene. They are made once, by lab 09's functions, and searched alone: by lab 09's
// functions in a kernel, one ray a work-item, the shadow rays by lab 10's tiles, and all by each of
// Embree's calls.
//
// All answers are compared before any figure is printed.
// Read next: shadow_tiles.h.
#ifndef BENCH_SECONDARY_RAYS_H
#define BENCH_SECONDARY_RAYS_H

#include "bench.h"
#include "case3d.h"
#include "embree_peer.h"
#include "secondary_ray.h"
#include "shadow_tiles.h"

// What searches the rays.
typedef enum Searcher {
    LAB_09,           // with the tree of lab 06
    LAB_10,           // shadow rays alone, with its own tree
    EMBREE_SEARCHES,  // with its first call; its other calls follow
    N_SEARCHERS = EMBREE_SEARCHES + N_EMBREE_CALLS,
} Searcher;

// The rays of one kind, light by light, those of neighbouring pixels together.
typedef struct RayList {
    SecondaryRay *rays;  // [n_rays]
    int n_rays;
    cl_mem d_rays, d_answers;
    cl_kernel kernel;  // its arguments are set
    u32 *answers;      // [n_rays], lab 09's of the first round
    u32 *other_answers;
} RayList;

typedef struct SecondaryRays {
    RayList lists[N_RAY_KINDS];  // RayKind: embree_peer.h
    int *light_starts;           // [n_lights + 1]: see ShadowTiles
    ShadowTiles tiles;
} SecondaryRays;

// Make the rays of a case that is prepared, and run a first work-group of each kernel. Returns 0,
// or -1 after one message. Release with secondary_rays_free(), after a failure too.
int secondary_rays_prepare(SecondaryRays *secondary, const ClSetup *cl, const Case3D *bench_case);
void secondary_rays_free(SecondaryRays *secondary);

// A round: search all rays several times in each way, one way after the other.
//   n_threads   of Embree; 0 when it takes no part
// Returns 0, or -1 after one message: answers are missing, or more differ than rounding explains.
int secondary_rays_measure(SecondaryRays *secondary, const ClSetup *cl, const Case3D *bench_case,
                           int n_threads, Measurements *measurements);

#endif
