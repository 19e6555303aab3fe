// Lab 10: ray tracing tile by tile; the picture of lab 07, sooner. Nothing to fill in here.
//
// Flow: scene -> buffers (a tree of lab 08) -> KERNEL -> image -> comparison. Started by main.c.
#include "shade_block.cl"
#include "tile_rays.cl"
#include "trace_tile.cl"

// Colours as bytes, red lowest, opaque: what a window shows. Four bytes a pixel where an image of
// floats has sixteen, and on a CPU no call for each pixel.
static LaneUints pack_colors(LaneColors colors)
{
    const LaneUints r = JOIN(convert_uint, LANES)(clamp(colors.r, 0.0f, 1.0f) * 255.0f + 0.5f);
    const LaneUints g = JOIN(convert_uint, LANES)(clamp(colors.g, 0.0f, 1.0f) * 255.0f + 0.5f);
    const LaneUints b = JOIN(convert_uint, LANES)(clamp(colors.b, 0.0f, 1.0f) * 255.0f + 0.5f);
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

// Draw the spheres, one work-item a tile.
//   spheres ... height           as in render_spheres of lab 05
//   pixels                       out: [height * width], RGBA, a byte each, red lowest
//   nodes, sphere_ids, bounds    the packed tree over the spheres (kdtree3d.h)
//   leaf_spheres                 spheres[sphere_ids[i]]
//   d_work                       what each pixel's tile cost; NULL where nothing is counted
kernel void render_tiles(global const Sphere *spheres, global const uint *material_ids,
                         global const Material *materials, global const Light *lights, int n_lights,
                         Vec3 background, Camera camera, int width, int height, global uint *pixels,
                         global const KdNode3 *nodes, global const uint *sphere_ids, BBox3D bounds,
                         global const Sphere *leaf_spheres, global Work *d_work)
{
    const int x = get_global_id(0) * TILE_WIDTH;
    const int y = get_global_id(1) * TILE_HEIGHT;
    if (x >= width || y >= height) {
        return;
    }
    const Shading shading = {spheres, material_ids, materials, lights, n_lights, background};
    Tile tile;
    TileHits hits;
    Work work = {0, 0, 0, 0};
    tile_create(x, y, width, height, camera, &tile);
    trace_tile(&tile, nodes, sphere_ids, leaf_spheres, bounds, &hits, &work);
    for (int block = 0; block < N_BLOCKS; block++) {
        const LaneColors colors = shade_block(&tile, block, &hits, &shading);
        save_block(pack_colors(colors), x, y, block, width, height, pixels);
    }
    save_work(work, x, y, width, height, d_work);
}
