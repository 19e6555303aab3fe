// Lab 10: which points does a light reach? The ways from a light to points that lie close together
// are a tile of rays, as those from an eye are: one search through the tree is enough for all. Lab
// 09 goes the other way: its rays to one light all start at different points. Nothing to fill in
// here; lay it beside trace_tile.cl, and shadows.cl of lab 09.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_lit_tiles.cl.
#include "tile_rays.cl"
#include "tile_surfaces.cl"
#include "trace_tile.cl"

// The ways from a light to what a tile's rays have hit.
typedef struct LightTile {
    Tile rays;                   // its eye is the light
    Lanes distance[N_BLOCKS];    // from the light to the point
    Lanes cosine[N_BLOCKS];      // of the angle between the normal and the way to the light
    LaneInts is_open[N_BLOCKS];  // -1 as long as nothing is known to stand in the way, else 0
} LightTile;

// How much wider the directions' intervals are than the ways: a light may be far away, and with u =
// 2^-24 a distance from it to a plane is off by 3 u of itself, a direction by 4 u.
#define WAY_ERROR 0x1p-21f

// The direction of an open way, whichever; (0, 0, 0) where there is none.
static float3 open_direction(const LightTile *ways)
{
    float3 direction = (float3)(0.0f);
    for (int block = 0; block < N_BLOCKS; block++) {
        int is_open[LANES];
        float x[LANES], y[LANES], z[LANES];
        JOIN(vstore, LANES)(ways->is_open[block], 0, is_open);
        JOIN(vstore, LANES)(ways->rays.x[block], 0, x);
        JOIN(vstore, LANES)(ways->rays.y[block], 0, y);
        JOIN(vstore, LANES)(ways->rays.z[block], 0, z);
        for (int lane = 0; lane < LANES; lane++) {
            if (is_open[lane]) {
                direction = (float3)(x[lane], y[lane], z[lane]);
            }
        }
    }
    return direction;
}

// Ways that are not open get the direction of an open one, so that they widen neither the
// directions' intervals nor the cone.
static void redirect_closed_ways(LightTile *ways)
{
    const float3 direction = open_direction(ways);
    Tile *rays = &ways->rays;
    for (int block = 0; block < N_BLOCKS; block++) {
        const LaneInts is_open = ways->is_open[block];
        rays->x[block] = select((Lanes)direction.x, rays->x[block], is_open);
        rays->y[block] = select((Lanes)direction.y, rays->y[block], is_open);
        rays->z[block] = select((Lanes)direction.z, rays->z[block], is_open);
    }
}

// What holds for all ways, whose directions are there. The cone is wide enough (CONE_ERROR).
static void ways_bound(LightTile *ways)
{
    tile_bound(&ways->rays);
    for (int axis = 0; axis < 3; axis++) {
        ways->rays.directions[axis].low -= WAY_ERROR;
        ways->rays.directions[axis].high += WAY_ERROR;
    }
}

// The ways from a light. Open are those to the surfaces that face it.
static void light_tile_create(const TileSurfaces *at, float3 position, LightTile *ways)
{
    Tile *rays = &ways->rays;
    rays->eye = position;
    for (int block = 0; block < N_BLOCKS; block++) {
        const Lanes x = block_of(at->x, block) - position.x;
        const Lanes y = block_of(at->y, block) - position.y;
        const Lanes z = block_of(at->z, block) - position.z;
        const Lanes distance = lane_lengths(x, y, z);
        rays->x[block] = x / distance;
        rays->y[block] = y / distance;
        rays->z[block] = z / distance;
        ways->distance[block] = distance;
        ways->cosine[block] =
            -(block_of(at->nx, block) * rays->x[block] + block_of(at->ny, block) * rays->y[block] +
              block_of(at->nz, block) * rays->z[block]);
        ways->is_open[block] = block_is_hit(at, block) & (ways->cosine[block] > 0.0f);
    }
    redirect_closed_ways(ways);
    ways_bound(ways);
}

// The way to the farthest point that is open; -1 where none is.
static float farthest_open(const LightTile *ways)
{
    Lanes farthest = -1.0f;
    for (int block = 0; block < N_BLOCKS; block++) {
        farthest =
            fmax(farthest, select((Lanes)(-1.0f), ways->distance[block], ways->is_open[block]));
    }
    return largest_lane(farthest);
}

// Close the ways of a block that a sphere blocks. They are tested from the point, as in lab 09:
// rounding is smallest there, beside the sphere that the point is on.
static void close_blocked_ways(const TileSurfaces *at, int block, Sphere sphere, LightTile *ways)
{
    const Tile *rays = &ways->rays;
    const Lanes cx = sphere.x - block_of(at->x, block);
    const Lanes cy = sphere.y - block_of(at->y, block);
    const Lanes cz = sphere.z - block_of(at->z, block);
    const Lanes b = -(cx * rays->x[block] + cy * rays->y[block] + cz * rays->z[block]);
    const Lanes x = cx + b * rays->x[block];
    const Lanes y = cy + b * rays->y[block];
    const Lanes z = cz + b * rays->z[block];
    const Lanes disc = sphere.radius * sphere.radius - (x * x + y * y + z * z);
    const Lanes half_chord = sqrt(disc);  // NaN where the way misses: every comparison then fails
    const Lanes t_near = sphere.radius > 0.0f ? b - half_chord : -1.0f;
    const Lanes t_far = b + half_chord;
    const Lanes t = select(t_far, t_near, t_near > 0.0f);
    ways->is_open[block] &= ~((t > 0.0f) & (t < ways->distance[block]));
}

// Test the spheres of a leaf, except for those that no way meets.
static void search_light_leaf(const TileSurfaces *at, KdNode3 node,
                              global const Sphere *leaf_spheres, LightTile *ways, Work *work)
{
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const Sphere sphere = leaf_spheres[i];
        const float3 centre = (float3)(sphere.x, sphere.y, sphere.z) - ways->rays.eye;
        if (cone_misses_sphere(ways->rays.cone, centre, sphere.radius)) {
            continue;
        }
        count_test(work);
        for (int block = 0; block < N_BLOCKS; block++) {
            close_blocked_ways(at, block, sphere, ways);
        }
    }
}

// Close every way that a sphere blocks: trace_tile() with another end. What begins behind the
// farthest open point is left out; where no way is open, that is all.
//   work   what the tile has cost so far
static void light_tile_trace(const TileSurfaces *at, const TracedScene *scene,
                             global const Sphere *leaf_spheres, LightTile *ways, Work *work)
{
#ifdef NO_SHADOWS  // key L of the window draws without: all light arrives
    return;
#endif
    const Tile *rays = &ways->rays;
    const float eye[3] = {rays->eye.x, rays->eye.y, rays->eye.z};
    TodoEntry next = {0, 0.0f, farthest_open(ways)};
    if (!clip_tile_to_box(scene->bounds, eye, rays->directions, &next)) {
        return;
    }
    Todo todo;
    todo.n = 0;
    for (;;) {
        const KdNode3 node =
            descend_to_leaf(scene->nodes, eye, rays->directions, &next, &todo, work);
        search_light_leaf(at, node, leaf_spheres, ways, work);
        if (!next_tile_waiting(farthest_open(ways), &todo, &next)) {
            return;
        }
    }
}
