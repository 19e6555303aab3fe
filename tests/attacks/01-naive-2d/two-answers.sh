#!/bin/sh
# attack: two wrong answers for one task, one that the whole runs and one between the markers: the checks of both count
# score: 99
# named: boundary|nearer
cat >overlaps_N_Nearer.cl <<'C'
#include "circle.h"
int overlaps_N_Nearer(int x, int y, Circle circle, float minDepth, Work *work)
{
    const float dx = x - circle.x, dy = y - circle.y, d = dx * dx + dy * dy, r = circle.radius * circle.radius;
#if 0
    // TASK overlaps_N_Nearer: wrong: never looks at the depth
    const float dx = x - circle.x, dy = y - circle.y, d = dx * dx + dy * dy, r = circle.radius * circle.radius;
    return d <= r;
    // END overlaps_N_Nearer
#endif
    return d < r && circle.depth < minDepth;  // wrong: the boundary is missing
}
C
