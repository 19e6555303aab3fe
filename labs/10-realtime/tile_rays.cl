// Lab 10: the rays of a tile, and what holds for all of them. Nothing to fill in here.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by render_tiles.cl and tile_light.cl.
#include "tile.h"
#include "vec3.h"

// How much wider a tile's cone is than its rays: more than rounding may add to the angle between a
// ray and a sphere. With u = 2^-24: a direction is off by 4 u, the axis by as much, the sine by 4
// u, and what intersect_block() and cone_misses_sphere() find of a centre at distance 1 by 12 u
// each.
#define CONE_ERROR 0x1p-18f

// The pixels of a block of a tile.
//   x, y   of the tile's first pixel
// Beside the picture's right and lower border the last pixel is traced again: no lane needs a case
// of its own.
static void block_pixels(int x, int y, int block, int width, int height, LaneInts *xs, LaneInts *ys)
{
    const LaneInts number = block * LANES + lane_number();
    *xs = min(x + number % TILE_WIDTH, width - 1);
    *ys = min(y + number / TILE_WIDTH, height - 1);
}

// The rays of a block: primary_ray() of lab 04, for LANES pixels at once.
static void block_rays(Tile *tile, int block, LaneInts xs, LaneInts ys, int width, int height,
                       Camera camera)
{
    const float pixel_size = camera.fov / width;
    const Lanes right = (JOIN(convert_float, LANES)(xs) + 0.5f - 0.5f * width) * pixel_size;
    const Lanes up = (0.5f * height - (JOIN(convert_float, LANES)(ys) + 0.5f)) * pixel_size;
    const Lanes x = right * camera.right.x + up * camera.up.x + camera.forward.x;
    const Lanes y = right * camera.right.y + up * camera.up.y + camera.forward.y;
    const Lanes z = right * camera.right.z + up * camera.up.z + camera.forward.z;
    const Lanes scale = 1.0f / sqrt(x * x + y * y + z * z);
    tile->x[block] = x * scale;
    tile->y[block] = y * scale;
    tile->z[block] = z * scale;
}

// From the least to the greatest of a tile's numbers.
static Interval interval_of(const Lanes *blocks)
{
    Lanes low = blocks[0], high = blocks[0];
    for (int block = 1; block < N_BLOCKS; block++) {
        low = fmin(low, blocks[block]);
        high = fmax(high, blocks[block]);
    }
    return (Interval){-largest_lane(-low), largest_lane(high)};
}

// The cone around the rays. Its axis is the mean of the extreme directions on each axis; how wide
// it is, the ray says that is farthest off.
static Cone cone_around(const Tile *tile)
{
    const Interval *directions = tile->directions;
    Cone cone;
    cone.axis = normalize((float3)(directions[0].low + directions[0].high,
                                   directions[1].low + directions[1].high,
                                   directions[2].low + directions[2].high));
    Lanes most_aside = 0.0f;
    Lanes least_along = 1.0f;
    for (int block = 0; block < N_BLOCKS; block++) {
        const Lanes along = tile->x[block] * cone.axis.x + tile->y[block] * cone.axis.y +
                            tile->z[block] * cone.axis.z;
        const Lanes x = tile->x[block] - along * cone.axis.x;
        const Lanes y = tile->y[block] - along * cone.axis.y;
        const Lanes z = tile->z[block] - along * cone.axis.z;
        most_aside = fmax(most_aside, x * x + y * y + z * z);
        least_along = fmin(least_along, along);
    }
    cone.sine = sqrt(largest_lane(most_aside)) + CONE_ERROR;
    if (-largest_lane(-least_along) > 0.0f && cone.sine < 1.0f) {
        cone.cosine = sqrt(1.0f - cone.sine * cone.sine) - CONE_ERROR;
    } else {
        // A tile of half a view of more than 90 degrees, or the ways from a light to points all
        // around it: no sphere is outside of this one.
        cone.sine = 0.0f;
        cone.cosine = -1.0f;
    }
    return cone;
}

// What holds for all rays of a tile, whose directions are there.
static void tile_bound(Tile *tile)
{
    tile->directions[0] = interval_of(tile->x);
    tile->directions[1] = interval_of(tile->y);
    tile->directions[2] = interval_of(tile->z);
    tile->cone = cone_around(tile);
}

// The tile whose first pixel is (x, y).
static void tile_create(int x, int y, int width, int height, Camera camera, Tile *tile)
{
    tile->eye = to_float3(camera.eye);
    for (int block = 0; block < N_BLOCKS; block++) {
        LaneInts xs, ys;
        block_pixels(x, y, block, width, height, &xs, &ys);
        block_rays(tile, block, xs, ys, width, height, camera);
    }
    tile_bound(tile);
}
