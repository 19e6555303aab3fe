// Lab 10: lab 09's picture, with shadows and mirrors, tile by tile. Nothing to fill in here.
//
// Two of three kinds of rays share a point: those from the eye, and those from a light. They go as
// tiles. Mirrored rays part, each goes by itself.
// Flow: scene -> buffers (a tree of lab 08) -> KERNEL -> image. Started by main.c.
#include "tile_light.cl"
#include "tile_pixels.cl"

// Add the light that comes straight from one light.
static void add_light(const TileSurfaces *at, Light light, const TracedScene *scene,
                      global const Sphere *leaf_spheres, LaneColors *colors, Work *work)
{
    LightTile ways;
    light_tile_create(at, to_float3(light.position), &ways);
    light_tile_trace(at, scene, leaf_spheres, &ways, work);
    for (int block = 0; block < N_BLOCKS; block++) {
        const Lanes share = select((Lanes)(0.0f), ways.cosine[block], ways.is_open[block]);
        colors[block].r += share * light.color.x * block_of(at->r, block);
        colors[block].g += share * light.color.y * block_of(at->g, block);
        colors[block].b += share * light.color.z * block_of(at->b, block);
    }
}

// Add what a block's surfaces show as mirrors: ray_color() of lab 09, ray by ray. It begins to
// count anew what a ray's light weighs, so it may follow a ray where lab 09 ends. That adds no more
// than what lab 09 leaves out there: see LEAST_WEIGHT.
static void add_mirrors(const Tile *tile, const TileSurfaces *at, int block, int max_bounces,
                        const TracedScene *scene, LaneColors *colors, Work *work)
{
    float x[LANES], y[LANES], z[LANES];  // the directions
    float r[LANES], g[LANES], b[LANES];
    JOIN(vstore, LANES)(tile->x[block], 0, x);
    JOIN(vstore, LANES)(tile->y[block], 0, y);
    JOIN(vstore, LANES)(tile->z[block], 0, z);
    for (int lane = 0; lane < LANES; lane++) {
        const int i = block * LANES + lane;
        float3 color = (float3)(0.0f);
        if (at->is_hit[i] && at->ks[i] >= LEAST_WEIGHT) {
            const float3 normal = (float3)(at->nx[i], at->ny[i], at->nz[i]);
            const Ray ray = {(float3)(at->x[i], at->y[i], at->z[i]),
                             mirrored_direction((float3)(x[lane], y[lane], z[lane]), normal), 0.0f,
                             INFINITY};
            color = at->ks[i] * ray_color(ray, max_bounces - 1, scene, work);
        }
        r[lane] = color.x, g[lane] = color.y, b[lane] = color.z;
    }
    colors->r += JOIN(vload, LANES)(0, r);
    colors->g += JOIN(vload, LANES)(0, g);
    colors->b += JOIN(vload, LANES)(0, b);
}

// Draw the spheres with shadows and as mirrors, one work-item a tile.
//   spheres ... leaf_spheres   as in render_tiles
//   max_bounces                a ray is mirrored at most this many times; 0: never
//   d_work                     what each pixel's tile cost; NULL where nothing is counted
kernel void render_lit_tiles(global const Sphere *spheres, global const uint *material_ids,
                             global const Material *materials, global const Light *lights,
                             int n_lights, Vec3 background, Camera camera, int width, int height,
                             global uint *pixels, global const KdNode3 *nodes,
                             global const uint *sphere_ids, BBox3D bounds,
                             global const Sphere *leaf_spheres, int max_bounces,
                             global Work *d_work)
{
    const int x = get_global_id(0) * TILE_WIDTH;
    const int y = get_global_id(1) * TILE_HEIGHT;
    if (x >= width || y >= height) {
        return;
    }
    const TracedScene scene = {spheres, material_ids, materials,
                               lights,  n_lights,     to_float3(background),
                               nodes,   sphere_ids,   bounds};
    Tile tile;
    TileHits hits;
    TileSurfaces at;
    LaneColors colors[N_BLOCKS];
    Work work = {0, 0, 0, 0};
    tile_create(x, y, width, height, camera, &tile);
    trace_tile(&tile, nodes, sphere_ids, leaf_spheres, bounds, &hits, &work);
    surfaces_find(&tile, &hits, &scene, &at);
    for (int block = 0; block < N_BLOCKS; block++) {
        const LaneInts is_hit = block_is_hit(&at, block);
        colors[block].r = select((Lanes)background.x, (Lanes)(0.0f), is_hit);
        colors[block].g = select((Lanes)background.y, (Lanes)(0.0f), is_hit);
        colors[block].b = select((Lanes)background.z, (Lanes)(0.0f), is_hit);
    }
    for (int i = 0; i < n_lights; i++) {
        add_light(&at, lights[i], &scene, leaf_spheres, colors, &work);
    }
    for (int block = 0; block < N_BLOCKS; block++) {
        if (max_bounces > 0) {
            add_mirrors(&tile, &at, block, max_bounces, &scene, &colors[block], &work);
        }
        save_block(pack_colors(colors[block]), x, y, block, width, height, pixels);
    }
    save_work(work, x, y, width, height, d_work);
}
