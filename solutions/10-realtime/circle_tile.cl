// Lab 10, Part A: lab 03 for a tile of pixels: one descent for all of them, and one test for a row.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_circles.cl.
#include "circle_tiles.h"
#include "lanes.h"
#include "work.h"

// Does a node have children? If it does, this counts a step, because one of them is visited next.
static int is_inner(TileNode node, Work *work)
{
    if (node.split_axis == KD_LEAF) {
        return 0;
    }
    count_node(work);
    return 1;
}

// The leaf that holds a tile.
//   x, y    the tile's first pixel, from 0 on; the others are in the same leaf
//   nodes   the tree (circle_tiles.h), of any size; node 0 is the root
//   work    what the tile has cost so far; each inner node on the way adds a step
// Returns the leaf's id.
uint tile_leaf(int x, int y, global const TileNode *nodes, Work *work)
{
    uint id = 0;
    // TASK tile_leaf: from the root go to the child that holds the pixel (x, y) until id is a leaf.
    // Pixel split_pos itself is on the upper side. Call is_inner() once a node: it counts steps.
    //> (void)x, (void)y, (void)nodes, (void)work;
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
    // END tile_leaf
    return id;
}

// Paint a circle into one row of a tile, behind the circles that are there already.
//   dx_squared       for each pixel: its distance from the centre along x, squared
//   dy               the row's distance from the centre along y, not squared
//   radius_squared   the circle's; the boundary belongs to it
//   color            the circle's
//   open             in and out: -1 where no circle has covered the pixel yet, else 0
//   colors           in and out: the row's colours
void paint_row(Lanes dx_squared, float dy, float radius_squared, uint color, LaneInts *open,
               LaneUints *colors)
{
    // TASK paint_row: overlaps_N_Nearer for LANES pixels at once. There is no `if` for lanes: which
    // lanes does the circle cover, and which of them are open? select() their colour, close them.
    //> (void)dx_squared, (void)dy, (void)radius_squared, (void)color, (void)open, (void)colors;
    const LaneInts covers = *open & (dx_squared + dy * dy <= radius_squared);
    *colors = select(*colors, (LaneUints)color, covers);
    *open &= ~covers;
    // END paint_row
}
