// What is in the image that lab 00's read_back is given: worked out from a number, so that it does
// not lie about where it could be copied from. The judge knows it by the same function.
#ifndef PROBES_PATTERN_H
#define PROBES_PATTERN_H

#include "layout.h"

// Value number i of the pattern that belongs to `key`: a float from -2 to 2, exactly.
static inline float pattern_value(u32 key, u32 i)
{
    u32 bits = (i + 1) * 0x9e3779b9u ^ key;
    bits = (bits ^ bits >> 16) * 0x7feb352du;
    bits = (bits ^ bits >> 15) * 0x846ca68bu;
    return (float)((i32)((bits ^ bits >> 16) & 0xfffffu) - 0x80000) / 0x1p18f;
}

#endif
