// Shadow rays of the 3D bench, searched as lab 10 does: tile by tile, from their light.
//
// In the list of secondary_rays.h the rays of a light stand together, and there those of
// neighbouring pixels: as many as a tile has, one behind the other, are close enough to be one.
// Read next: shadow_tiles.cl.
#ifndef BENCH_SHADOW_TILES_H
#define BENCH_SHADOW_TILES_H

#include "case3d.h"

typedef struct ShadowTiles {
    cl_kernel kernel;     // what it takes for all lights is set
    int rays_a_tile;      // the device's: see tile_shape()
    size_t group_tiles;   // tiles of a work-group
    const Light *lights;  // [n_lights], the scene's
    const int
        *light_starts;  // [n_lights + 1], where the rays of each begin; at last, where all end
    int n_lights;
} ShadowTiles;

// Make everything ready to be searched, and run a first work-group.
//   light_starts        stays the caller's, as long as the tiles are there
//   d_rays, d_answers   of all lights
// Returns 0, or -1 after one message. Release with shadow_tiles_free(), after a failure too.
int shadow_tiles_prepare(ShadowTiles *tiles, const ClSetup *cl, const Case3D *bench_case,
                         const int *light_starts, cl_mem d_rays, cl_mem d_answers);
void shadow_tiles_free(ShadowTiles *tiles);

// Search all rays, light by light, and wait for the answers.
void shadow_tiles_search(const ShadowTiles *tiles, const ClSetup *cl);

#endif
