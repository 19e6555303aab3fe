// Lab 01: implicit 2D rendering, the naive way: every pixel tests every circle.
//
// Flow: scene -> buffers -> KERNEL -> image. Started by main.c.
#include "overlaps_N_Nearer.cl"
#include "work.h"

// Draw the circles, one work-item per pixel.
//   circles[n_circles]   the scene
//   width, height        the picture, pixels; work-items outside it write nothing
//   image                RGBA float, width x height; row 0 is the top row
//   d_work               what each pixel cost; NULL if nothing is counted
// A pixel that no circle covers is (0, 0, 0, 0).
// Source: slide "Wiederholung: 2D implizites Rendern".
kernel void implicit2DRenderer(global const Circle *circles, int n_circles, int width, int height,
                               write_only image2d_t image, global Work *d_work)
{
    // TASK own_pixel: x is the column, y the row. Spare work-items, outside the picture, return.
    (void)width, (void)height;
    const int x = 0;
    const int y = 0;
    // END own_pixel

    Work work = {0, 0, 0, 0};
    float4 color = (float4)(0.0f);
    // TASK implicit2DRenderer: test every circle, in array order, and keep the colour of the
    // nearest one that covers the pixel. Pass &work to each call: it counts.
    (void)circles, (void)n_circles;
    // END implicit2DRenderer
    write_imagef(image, (int2)(x, y), color);
    work_save(work, x, y, width, d_work);
}
