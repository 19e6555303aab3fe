// Part A: circles, tile by tile. Given.
#ifndef CIRCLES_H
#define CIRCLES_H

#include "lab.h"
#include "tile_buffers.h"

// What --leaf-size is where it is not given. A circle is tested for a whole row at once, so a test
// in vain costs little: leaves are smaller only where the device has few lanes.
#define CIRCLE_LEAF_SIZE 8

// Draw the 2D scene of the command line and save the picture, with the figures and the work.
void draw_circles(Lab *lab);

// The shape of Part A's tiles: as many rows as a row has pixels.
TileShape circle_tile_shape(cl_device_id device);

// Launch a kernel with one work-item a tile, as EnqueuePixels (lab.h).
void enqueue_circle_tiles(cl_command_queue queue, cl_kernel kernel, int width, int height);

#endif
