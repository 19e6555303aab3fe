// Random numbers that are the same on every machine: SplitMix64 (Steele, Lea, Flood 2014).
//
// Read next: scene2d_random.c.
#ifndef COMMON_RANDOM_H
#define COMMON_RANDOM_H

#include <stdint.h>

// The state; start it with any seed.
typedef struct Random {
    uint64_t state;
} Random;

// The next 64 random bits.
static inline uint64_t random_bits(Random *random)
{
    uint64_t z = (random->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

// A whole number from lowest to highest, both included; lowest <= highest.
static inline int64_t random_integer(Random *random, int64_t lowest, int64_t highest)
{
    return lowest + (int64_t)(random_bits(random) % (uint64_t)(highest - lowest + 1));
}

// A coordinate on the course's grid of 1/16 px, from lowest to highest pixel.
static inline float random_grid(Random *random, int lowest, int highest)
{
    return (float)random_integer(random, 16 * (int64_t)lowest, 16 * (int64_t)highest) / 16;
}

#endif
