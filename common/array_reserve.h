// Arrays that grow: the one way in which the builders of labs 02, 06 and 08 make room.
//
// Read next: kdtree2d_build.c of lab 02.
#ifndef COMMON_ARRAY_RESERVE_H
#define COMMON_ARRAY_RESERVE_H

#include "layout.h"

#include <stdlib.h>

// Make room for n more elements behind the `used` ones; doubling keeps growing cheap.
//   array       NULL at first; release with free()
//   capacity    in and out: how many elements there is room for
//   n_bytes     of one element
// Returns the array, perhaps moved, or NULL when memory runs out: the old one is then still there.
static inline void *array_reserve(void *array, u32 used, u32 n, u32 *capacity, size_t n_bytes)
{
    if (array != NULL && n <= *capacity - used) {
        return array;
    }
    const size_t larger = 2 * ((size_t)used + n) + 1;  // realloc() may answer NULL to a size of 0
    void *moved = larger <= UINT32_MAX ? realloc(array, larger * n_bytes) : NULL;
    if (moved != NULL) {
        *capacity = (u32)larger;
    }
    return moved;
}

#endif
