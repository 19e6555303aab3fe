// Lab 10: what the rays of a tile have hit, as new rays need it. Nothing to fill in here.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_lit_tiles.cl.
#include "mirrors.cl"
#include "tile.h"

// Surface of lab 09 for each ray of a tile, its numbers side by side: so that a ray can be tested
// by itself, and a block of them as lanes.
typedef struct TileSurfaces {
    int is_hit[N_RAYS];                     // -1 where there is one, else 0
    float x[N_RAYS], y[N_RAYS], z[N_RAYS];  // points, off the surface already: new rays start here
    float nx[N_RAYS], ny[N_RAYS], nz[N_RAYS];  // normals, to the side the rays came from
    float r[N_RAYS], g[N_RAYS], b[N_RAYS];     // colours times kd
    float ks[N_RAYS];
} TileSurfaces;

// A block's part of one of these numbers.
static Lanes block_of(const float *numbers, int block)
{
    return JOIN(vload, LANES)(block, numbers);
}

// Where a block's rays have hit something: -1, else 0.
static LaneInts block_is_hit(const TileSurfaces *at, int block)
{
    return JOIN(vload, LANES)(block, at->is_hit);
}

// Of a ray without a hit.
static Surface no_surface(void)
{
    const Surface none = {
        (float3)(0.0f), (float3)(0.0f), {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f}};
    return none;
}

// The surfaces at a tile's hits: surface_at() of lab 09, ray by ray, as each reads from another
// place.
static void surfaces_find(const Tile *tile, const TileHits *hits, const TracedScene *scene,
                          TileSurfaces *at)
{
    float x[N_RAYS], y[N_RAYS], z[N_RAYS], t[N_RAYS];
    uint spheres[N_RAYS];
    for (int block = 0; block < N_BLOCKS; block++) {
        JOIN(vstore, LANES)(tile->x[block], block, x);
        JOIN(vstore, LANES)(tile->y[block], block, y);
        JOIN(vstore, LANES)(tile->z[block], block, z);
        JOIN(vstore, LANES)(hits->t[block], block, t);
        JOIN(vstore, LANES)(hits->sphere[block], block, spheres);
    }
    for (int i = 0; i < N_RAYS; i++) {
        const Hit hit = {t[i], spheres[i]};
        const Ray ray = {tile->eye, (float3)(x[i], y[i], z[i]), 0.0f, INFINITY};
        const int is_hit = hit.sphere != NO_SPHERE;
        const Surface surface = is_hit ? surface_at(ray, hit, scene) : no_surface();
        at->is_hit[i] = is_hit ? -1 : 0;
        const Material material = surface.material;
        at->x[i] = surface.point.x, at->y[i] = surface.point.y, at->z[i] = surface.point.z;
        at->nx[i] = surface.normal.x, at->ny[i] = surface.normal.y, at->nz[i] = surface.normal.z;
        at->r[i] = material.kd * material.color.x;
        at->g[i] = material.kd * material.color.y;
        at->b[i] = material.kd * material.color.z;
        at->ks[i] = material.ks;
    }
}
