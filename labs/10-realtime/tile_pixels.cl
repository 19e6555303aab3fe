// Lab 10: a tile's pixels and what they cost, written down. Nothing to fill in here.
//
// Flow: scene -> buffers -> KERNEL -> IMAGE. Called by render_tiles.cl and render_lit_tiles.cl.
#include "tile.h"
#include "work.h"

// Colours as bytes, each the nearest, as in a PNG; red lowest, opaque. Four bytes a pixel where an
// image of floats has sixteen, and on a CPU no call for each pixel.
static LaneUints pack_colors(LaneColors colors)
{
    const LaneUints r = JOIN(convert_uint, LANES)(rint(clamp(colors.r, 0.0f, 1.0f) * 255.0f));
    const LaneUints g = JOIN(convert_uint, LANES)(rint(clamp(colors.g, 0.0f, 1.0f) * 255.0f));
    const LaneUints b = JOIN(convert_uint, LANES)(rint(clamp(colors.b, 0.0f, 1.0f) * 255.0f));
    return r | g << 8 | b << 16 | 0xff000000u;
}

// Write what a block's pixels look like, but for those beside the picture.
//   x, y   of the tile's first pixel
static void save_block(LaneUints packed, int x, int y, int block, int width, int height,
                       global uint *pixels)
{
    uint colors[LANES];
    JOIN(vstore, LANES)(packed, 0, colors);
    for (int lane = 0; lane < LANES; lane++) {
        const int number = block * LANES + lane;
        const int to_x = x + number % TILE_WIDTH, to_y = y + number / TILE_WIDTH;
        if (to_x < width && to_y < height) {
            pixels[to_y * width + to_x] = colors[lane];
        }
    }
}

// Write down what a tile cost, for each of its pixels.
static void save_work(Work work, int x, int y, int width, int height, global Work *d_work)
{
    for (int i = 0; IS_COUNTING && i < TILE_WIDTH * TILE_HEIGHT; i++) {
        const int to_x = x + i % TILE_WIDTH, to_y = y + i / TILE_WIDTH;
        if (to_x < width && to_y < height) {
            work_save(work, to_x, to_y, width, d_work);
        }
    }
}
