// Lab 10: ray tracing tile by tile; the picture of lab 07, sooner. Nothing to fill in here.
//
// Flow: scene -> buffers (a tree of lab 08) -> KERNEL -> image. Started by main.c.
#include "shade_block.cl"
#include "tile_pixels.cl"
#include "tile_rays.cl"
#include "trace_tile.cl"

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
