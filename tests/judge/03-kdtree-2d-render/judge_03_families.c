// Inputs of lab 03's getContainingChild: nodes whose borders lie just beside a whole pixel. See
// judge_03.h.
#include "judge_03.h"

#include <math.h>

// A cell, both ways from min to max, the border between its children, a coordinate before, at and
// behind which pixels are asked, and another one in the cell. Most borders lie beside that pixel by
// a little: 2^-17 parts floats at 100.
static const struct {
    float min, max, border;
    i32 at, other;
} families[N_FAMILIES] = {
    {90, 110, 100.25f, 100, 95},
    {90, 110, 100.5f, 100, 95},
    {90, 110, 100.75f, 101, 95},
    {90, 110, 100 + 0x1p-10f, 100, 95},
    {90, 110, 100 - 0x1p-10f, 100, 95},
    {90, 110, 100 + 0x1p-17f, 100, 95},
    {90, 110, 100 - 0x1p-17f, 100, 95},
    {-8, 16, 4, 4, 3},
    {-8.5f, 15.5f, 3.5f, 4, 0},
    {-8, 16, 0, 0, 3},
    {-8, 16, 0x1p-60f, 0, 3},
    {-8, 16, -0x1p-60f, 0, 3},
    {-8, 16, 1 + 0x1p-23f, 1, 3},
    {-8, 16, 1 - 0x1p-24f, 1, 3},
    // The cell's own borders beside a pixel.
    {1 - 0x1p-24f, 17, 9, 1, 5},
    {-8, 7 + 0x1p-21f, 0, 7, 3},
    {70000, 70020, 70010, 70010, 70005},
};

// Number `step` of a family's pixels along the split axis. None is on the border itself, which is
// what the check child-border asks.
static i32 family_pixel(u32 family, u32 step)
{
    const i32 at = families[family].at + (i32)step - 1;
    return step < 3    ? at - ((float)at == families[family].border)
           : step == 3 ? (i32)floorf(families[family].min) - 2
                       : (i32)ceilf(families[family].max) + 2;
}

void add_families(KdTree2D *more, ChildJob jobs[N_FAMILY_JOBS])
{
    for (u32 i = 0; i < 2 * N_FAMILIES; i++) {
        const u32 id = FAR_IDS + 3 * i;
        const float min = families[i / 2].min, max = families[i / 2].max;
        const float border = families[i / 2].border;
        const i32 other = families[i / 2].other;
        // In every second family the right child comes before the left one.
        const u32 lChild = id + 1 + i / 2 % 2, rChild = id + 2 - i / 2 % 2;
        BBox2D *boxes = more->nodes_BBox;
        more->nodes_Relations[id] = (NodeRel){id, lChild, rChild, 0};
        boxes[id] = boxes[lChild] = boxes[rChild] = (BBox2D){min, max, min, max};
        *(i % 2 == 0 ? &boxes[lChild].maxX : &boxes[lChild].maxY) = border;
        *(i % 2 == 0 ? &boxes[rChild].minX : &boxes[rChild].minY) = border;
        for (u32 step = 0; step < N_FAMILY_PIXELS; step++) {
            const i32 pixel = family_pixel(i / 2, step);
            *jobs++ =
                i % 2 == 0 ? (ChildJob){pixel, other, id, 0} : (ChildJob){other, pixel, id, 0};
        }
    }
}
