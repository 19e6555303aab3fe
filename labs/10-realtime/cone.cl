// Lab 10: which spheres of a leaf can be left out for a whole tile?
//
// Flow: scene -> buffers -> KERNEL -> image. Called by trace_tile.cl.
#include "tile.h"

// Do all rays of a tile miss a sphere for certain?
//   cone     around the tile's rays, a little wider than they are: rounding needs no care here
//   centre   the sphere's centre minus the eye
//   radius   may be negative
// Returns 1, or 0 if a ray may hit it. If the centre is behind the eye and no ray hits the sphere,
// either is right.
int cone_misses_sphere(Cone cone, float3 centre, float radius)
{
    // TASK cone_misses_sphere: in the plane through the axis and the centre the cone's border is a
    // straight line. How far from it, on the outer side, is the centre?
    (void)cone, (void)centre, (void)radius;
    return 0;
    // END cone_misses_sphere
}
