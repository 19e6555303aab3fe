// Lab 10: the colours of LANES rays: hit_color() of lab 05, lane by lane. Nothing to fill in here.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_tiles.cl.
#include "ray.h"
#include "shading.h"
#include "sphere.h"
#include "tile.h"

// What shading needs of a scene: see render_spheres of lab 05.
typedef struct Shading {
    global const Sphere *spheres;
    global const uint *material_ids;
    global const Material *materials;
    global const Light *lights;
    int n_lights;
    Vec3 background;
} Shading;

// What the lanes have hit, each its own: the centres, and the colours times kd. Lanes that hit
// nothing have the first sphere's, which nobody looks at.
typedef struct Surfaces {
    Lanes x, y, z;
    Lanes r, g, b;
} Surfaces;

// The one step that goes lane by lane: each reads from another place.
static Surfaces gather(LaneUints spheres, const Shading *shading)
{
    uint ids[LANES];
    float x[LANES], y[LANES], z[LANES], r[LANES], g[LANES], b[LANES];
    JOIN(vstore, LANES)(spheres, 0, ids);
    for (int lane = 0; lane < LANES; lane++) {
        const uint id = ids[lane] == NO_SPHERE ? 0 : ids[lane];
        const Sphere sphere = shading->spheres[id];
        const Material material = shading->materials[shading->material_ids[id]];
        x[lane] = sphere.x;
        y[lane] = sphere.y;
        z[lane] = sphere.z;
        r[lane] = material.kd * material.color.x;
        g[lane] = material.kd * material.color.y;
        b[lane] = material.kd * material.color.z;
    }
    const Surfaces surfaces = {JOIN(vload, LANES)(0, x), JOIN(vload, LANES)(0, y),
                               JOIN(vload, LANES)(0, z), JOIN(vload, LANES)(0, r),
                               JOIN(vload, LANES)(0, g), JOIN(vload, LANES)(0, b)};
    return surfaces;
}

// The colours of a block's rays.
static LaneColors shade_block(const Tile *tile, int block, const TileHits *hits,
                              const Shading *shading)
{
    const Vec3 background = shading->background;
    LaneColors colors = {background.x, background.y, background.z};
    const LaneInts is_hit = hits->sphere[block] != NO_SPHERE;
    if (!any(is_hit)) {
        return colors;
    }
    const Surfaces at = gather(hits->sphere[block], shading);
    const Lanes t = hits->t[block];
    const Lanes px = tile->eye.x + t * tile->x[block];
    const Lanes py = tile->eye.y + t * tile->y[block];
    const Lanes pz = tile->eye.z + t * tile->z[block];
    Lanes nx = px - at.x, ny = py - at.y, nz = pz - at.z;
    // To the side that the ray comes from.
    const Lanes cosine = nx * tile->x[block] + ny * tile->y[block] + nz * tile->z[block];
    const Lanes scale = copysign(1.0f / sqrt(nx * nx + ny * ny + nz * nz), -cosine);
    nx *= scale;
    ny *= scale;
    nz *= scale;
    LaneColors lit = {0.0f, 0.0f, 0.0f};
    for (int i = 0; i < shading->n_lights; i++) {
        const Light light = shading->lights[i];
        const Lanes x = light.position.x - px, y = light.position.y - py, z = light.position.z - pz;
        const Lanes share = fmax(0.0f, (nx * x + ny * y + nz * z) / lane_lengths(x, y, z));
        lit.r += share * light.color.x;
        lit.g += share * light.color.y;
        lit.b += share * light.color.z;
    }
    colors.r = select(colors.r, lit.r * at.r, is_hit);
    colors.g = select(colors.g, lit.g * at.g, is_hit);
    colors.b = select(colors.b, lit.b * at.b, is_hit);
    return colors;
}
