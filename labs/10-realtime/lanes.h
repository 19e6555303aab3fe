// Lanes: several rays instead of one. Their numbers are side by side in a vector, and one
// instruction computes all of them.
//
// How many there are, and how many pixels one tile has, the host says when it builds the kernel
// (tile_buffers.h): a CPU wants wide vectors and large tiles, a GPU small ones. Without that they
// are a CPU's. The device's own.
// Flow: scene -> buffers -> KERNEL -> image. Read next: tile.h.
#ifndef LANES_H
#define LANES_H

// Clang warns of functions that take vectors wider than the processor's registers: code compiled
// for another processor would pass them otherwise. Here all of it is compiled at once.
// Older clangs, and compilers made of them, do not know the warning, and would warn of its name.
#ifdef __has_warning
#if __has_warning("-Wpsabi")
#pragma clang diagnostic ignored "-Wpsabi"
#endif
#endif

#ifndef LANES
#define LANES 16  // 2, 4, 8 or 16: OpenCL C has vectors of these lengths
#define TILE_WIDTH 8
#define TILE_HEIGHT 8
#endif

// A tile's rays, and the number of vectors that they fill. Ray number i, row by row, is lane
// i % LANES of block i / LANES.
#define N_RAYS (TILE_WIDTH * TILE_HEIGHT)
#define N_BLOCKS (N_RAYS / LANES)

// LANES_TYPE(float) is float16 where LANES is 16.
#define JOIN_WORDS(a, b) a##b
#define JOIN(a, b) JOIN_WORDS(a, b)
#define LANES_TYPE(type) JOIN(type, LANES)

typedef LANES_TYPE(float) Lanes;
typedef LANES_TYPE(int) LaneInts;  // also what a comparison gives: -1 where it holds, else 0
typedef LANES_TYPE(uint) LaneUints;

constant int lane_numbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

// 0 in the first lane, 1 in the second, ...
static inline LaneInts lane_number(void)
{
    return JOIN(vload, LANES)(0, lane_numbers);
}

// The lengths of vectors, one a lane. As length(), finite where the numbers' squares are not: large
// ones are scaled by a power of two, which rounds nothing.
static inline Lanes lane_lengths(Lanes x, Lanes y, Lanes z)
{
    const LaneInts is_large = fmax(fmax(fabs(x), fabs(y)), fabs(z)) > 0x1p62f;
    const Lanes scale = select((Lanes)1.0f, (Lanes)0x1p-66f, is_large);
    const Lanes back = select((Lanes)1.0f, (Lanes)0x1p66f, is_large);
    x *= scale;
    y *= scale;
    z *= scale;
    return back * sqrt(x * x + y * y + z * z);
}

// The largest of all lanes: the upper half onto the lower one, until one is left. The halves are
// read from memory, which compilers see through.
static inline float largest_lane(Lanes lanes)
{
    float values[LANES];
    JOIN(vstore, LANES)(lanes, 0, values);
#if LANES == 16
    vstore8(fmax(vload8(0, values), vload8(1, values)), 0, values);
#endif
#if LANES >= 8
    vstore4(fmax(vload4(0, values), vload4(1, values)), 0, values);
#endif
#if LANES >= 4
    vstore2(fmax(vload2(0, values), vload2(1, values)), 0, values);
#endif
    return fmax(values[0], values[1]);
}

#endif
