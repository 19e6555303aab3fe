// Lab 10, Part A: the picture of lab 03, tile by tile. Nothing to fill in here; lay it beside
// implicit2DRenderer_KD.cl of lab 03.
//
// Flow: scene -> buffers -> KERNEL -> image. Started by circles.c.
#include "circle_tile.cl"

// A tile has as many rows as a row has pixels.
#define N_ROWS LANES

// After how many circles a tile is tested whether it is done: the test costs as much as a circle,
// and may save all that follow.
#define CIRCLES_A_LOOK 8

typedef struct CircleTile {
    int x, y;                  // its first pixel
    LaneInts open[N_ROWS];     // -1 where no circle has covered the pixel yet, else 0
    LaneUints colors[N_ROWS];  // RGBA, a byte each, red lowest
} CircleTile;

// Is a pixel left that no circle has covered?
static int is_open(const CircleTile *tile)
{
    LaneInts open = tile->open[0];
    for (int row = 1; row < N_ROWS; row++) {
        open |= tile->open[row];
    }
    return any(open);
}

// Paint a circle into the rows of a tile. The columns' part of the distance is the same for each of
// them. Rows that the circle does not meet are tested, too: that was measured to take no longer
// than the branch that leaves them out.
static void paint_circle(TileCircle circle, CircleTile *tile)
{
    const Lanes dx = JOIN(convert_float, LANES)(tile->x + lane_number()) - circle.x;
    const Lanes dx_squared = dx * dx;
    for (int row = 0; row < N_ROWS; row++) {
        const float dy = tile->y + row - circle.y;
        paint_row(dx_squared, dy, circle.radius_squared, circle.color, &tile->open[row],
                  &tile->colors[row]);
    }
}

// Paint the circles of a leaf, nearest first, until each pixel has its own: what comes after it is
// hidden.
static void paint_leaf(TileNode leaf, global const TileCircle *leaf_circles, CircleTile *tile,
                       Work *work)
{
    for (uint i = 0; i < leaf.n_circles; i++) {
        if (i % CIRCLES_A_LOOK == 0 && !is_open(tile)) {
            return;
        }
        count_test(work);
        paint_circle(leaf_circles[leaf.first + i], tile);
    }
}

// The tile whose first pixel is (x, y), painted.
static CircleTile draw_tile(int x, int y, global const TileNode *nodes,
                            global const TileCircle *leaf_circles, Work *work)
{
    CircleTile tile;
    tile.x = x;
    tile.y = y;
    for (int row = 0; row < N_ROWS; row++) {
        tile.open[row] = -1;
        tile.colors[row] = 0;
    }
    paint_leaf(nodes[tile_leaf(x, y, nodes, work)], leaf_circles, &tile, work);
    return tile;
}

// Write a tile's pixels, but for those beside the picture.
static void save_tile(const CircleTile *tile, int width, int height, global uint *pixels)
{
    for (int row = 0; row < N_ROWS && tile->y + row < height; row++) {
        global uint *to = pixels + (tile->y + row) * width + tile->x;
        if (tile->x + LANES <= width) {
            JOIN(vstore, LANES)(tile->colors[row], 0, to);
            continue;
        }
        uint colors[LANES];
        JOIN(vstore, LANES)(tile->colors[row], 0, colors);
        for (int lane = 0; tile->x + lane < width; lane++) {
            to[lane] = colors[lane];
        }
    }
}

// Write down what a tile cost, for each of its pixels.
static void save_tile_work(Work work, int x, int y, int width, int height, global Work *d_work)
{
    for (int i = 0; IS_COUNTING && i < LANES * N_ROWS; i++) {
        const int to_x = x + i % LANES, to_y = y + i / LANES;
        if (to_x < width && to_y < height) {
            work_save(work, to_x, to_y, width, d_work);
        }
    }
}

// Draw the circles, one work-item a tile; the same picture as implicit2DRenderer_KD, sooner, but
// for colours that are rounded to bytes here.
//   nodes           the tree (circle_tiles.h)
//   leaf_circles    the leaves' circles, nearest first in each
//   width, height   the picture, pixels; work-items outside it write nothing
//   pixels          out: [height * width], RGBA, a byte each, red lowest; 0 where no circle is
//   d_work          what each pixel's tile cost; NULL where nothing is counted
kernel void render_circles(global const TileNode *nodes, global const TileCircle *leaf_circles,
                           int width, int height, global uint *pixels, global Work *d_work)
{
    const int x = get_global_id(0) * LANES;
    const int y = get_global_id(1) * N_ROWS;
    if (x >= width || y >= height) {
        return;
    }
    Work work = {0, 0, 0, 0};
    const CircleTile tile = draw_tile(x, y, nodes, leaf_circles, &work);
    save_tile(&tile, width, height, pixels);
    save_tile_work(work, x, y, width, height, d_work);
}
