// Lab 01: the test of one circle for one pixel. Labs 01 and 03 build on it.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by implicit2DRenderer.cl.
#include "circle.h"
#include "work.h"

// Does the circle cover the pixel (x, y), and is it nearer than all circles found so far?
//   minDepth   the depth of the nearest circle found so far
//   work       what this pixel has cost so far; the call is counted
// Returns 1 or 0. The slides call this function and do not show it: it is our reconstruction.
int overlaps_N_Nearer(int x, int y, Circle circle, float minDepth, Work *work)
{
    count_test(work);
    // TASK overlaps_N_Nearer: the boundary belongs to the circle (distance² <= radius²), and
    // nearer is strict (depth < minDepth): at equal depths the circle tested first keeps the pixel.
    //> (void)x, (void)y, (void)circle, (void)minDepth;
    //> return 0;
    const float dx = x - circle.x;
    const float dy = y - circle.y;
    return circle.depth < minDepth && dx * dx + dy * dy <= circle.radius * circle.radius;
    // END overlaps_N_Nearer
}
