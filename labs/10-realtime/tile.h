// A tile: the rays from the eye through a small rectangle of pixels, or from a light to the points
// that these hit. They stay close together, so one test can decide for all of them. Device only.
//
// Flow: scene -> buffers -> KERNEL -> image. Read next: intervals.cl, cone.cl.
#ifndef TILE_H
#define TILE_H

#include "camera.h"
#include "lanes.h"

// All numbers from low to high.
typedef struct Interval {
    float low;
    float high;
} Interval;

// All directions that are no farther from the axis than an angle. It is below 90 degrees, or 180
// where the rays are farther apart: cosine -1 and sine 0, and every direction is in the cone.
typedef struct Cone {
    float3 axis;   // unit vector
    float cosine;  // of that angle
    float sine;
} Cone;

typedef struct Tile {
    float3 eye;                                   // where all rays start
    Lanes x[N_BLOCKS], y[N_BLOCKS], z[N_BLOCKS];  // their directions, unit vectors
    Interval directions[3];                       // on each axis: where these lie
    Cone cone;                                    // they are inside
} Tile;

// What each ray of a tile hits, as Hit of ray.h.
typedef struct TileHits {
    Lanes t[N_BLOCKS];
    LaneUints sphere[N_BLOCKS];
} TileHits;

// The colours of a block's rays.
typedef struct LaneColors {
    Lanes r, g, b;
} LaneColors;

#endif
