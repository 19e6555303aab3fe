// Bench: shadow rays, searched as lab 10 does: those to one light go as ways from it, a tile of
// them at once. Whose rays they are: secondary_rays.cl. Started by shadow_tiles.c.
#include "secondary_ray.h"
#include "tile_light.cl"

// Turn rays to a light round: light_tile_create() of lab 10, where all is known already.
//   position   of the light
//   rays       those of the tile, n_rays; the lanes behind them hold the last one, closed
//   at         out: where the rays begin, and nothing else
static void turn_rays(float3 position, global const SecondaryRay *rays, int n_rays,
                      TileSurfaces *at, LightTile *ways)
{
    float x[N_RAYS], y[N_RAYS], z[N_RAYS], distance[N_RAYS];
    for (int i = 0; i < N_RAYS; i++) {
        const SecondaryRay ray = rays[min(i, n_rays - 1)];
        at->x[i] = ray.origin.x, at->y[i] = ray.origin.y, at->z[i] = ray.origin.z;
        x[i] = -ray.direction.x, y[i] = -ray.direction.y, z[i] = -ray.direction.z;
        distance[i] = ray.t_max;
    }
    ways->rays.eye = position;
    for (int block = 0; block < N_BLOCKS; block++) {
        ways->rays.x[block] = block_of(x, block);
        ways->rays.y[block] = block_of(y, block);
        ways->rays.z[block] = block_of(z, block);
        ways->distance[block] = block_of(distance, block);
        ways->is_open[block] = block * LANES + lane_number() < n_rays;
    }
    redirect_closed_ways(ways);
    ways_bound(ways);
}

// Does anything stand in the way of the rays to one light? One work-item a tile: N_RAYS of them,
// one behind the other.
//   nodes, bounds, leaf_spheres   lab 10's tree
//   position                      of the light
//   first_ray, n_rays             which of the rays end there
//   answers                       out, for these: 1, or 0 where nothing does
kernel void search_shadow_tiles(global const KdNode3 *nodes, BBox3D bounds,
                                global const Sphere *leaf_spheres, global const SecondaryRay *rays,
                                global uint *answers, Vec3 position, int first_ray, int n_rays)
{
    const int first_of_tile = get_global_id(0) * N_RAYS;
    if (first_of_tile >= n_rays) {
        return;
    }
    const int first = first_ray + first_of_tile;
    const int n_here = min(N_RAYS, n_rays - first_of_tile);
    const TracedScene scene = {.nodes = nodes, .bounds = bounds};
    Work work = {0, 0, 0, 0};
    TileSurfaces at;
    LightTile ways;
    turn_rays(to_float3(position), rays + first, n_here, &at, &ways);
    light_tile_trace(&at, &scene, leaf_spheres, &ways, &work);
    int is_open[N_RAYS];
    for (int block = 0; block < N_BLOCKS; block++) {
        JOIN(vstore, LANES)(ways.is_open[block], block, is_open);
    }
    for (int i = 0; i < n_here; i++) {
        answers[first + i] = !is_open[i];
    }
}
