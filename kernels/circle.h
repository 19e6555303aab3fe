// One circle of a 2D scene: read from a file or generated on the host (common/scene2d.h), read by
// every 2D kernel. The slides use a Circle and do not show it: this is our reconstruction.
//
// Flow: SCENE -> BUFFERS -> KERNEL -> image. Read next: overlaps_N_Nearer.cl of lab 01.
#ifndef KERNELS_CIRCLE_H
#define KERNELS_CIRCLE_H

#include "layout.h"

// Row 0 is the top row; a pixel's sample point is its integer coordinate (x, y).
typedef struct Circle {
    /*  0 */ f32 x;       // centre, pixels to the right
    /*  4 */ f32 y;       // centre, pixels down
    /*  8 */ f32 radius;  // pixels; the boundary belongs to the circle
    /* 12 */ f32 depth;   // the smaller is the nearer; at equal depths the lower index wins
    /* 16 */ f32 r;       // colour, 0 to 1
    /* 20 */ f32 g;
    /* 24 */ f32 b;
    /* 28 */ f32 a;
} Circle;
LAYOUT_ASSERT(Circle, 32);

#endif
