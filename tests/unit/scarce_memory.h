// Memory that runs out when a test wants it to, for the sources that a test includes after this.
#ifndef UNIT_SCARCE_MEMORY_H
#define UNIT_SCARCE_MEMORY_H

#include <stdlib.h>

static int n_allocations_left = -1;  // negative: as many as one likes

static inline int may_allocate(void)
{
    if (n_allocations_left == 0) {
        return 0;
    }
    n_allocations_left -= n_allocations_left > 0;
    return 1;
}

#define malloc(n_bytes) (may_allocate() ? malloc(n_bytes) : NULL)
#define realloc(old, n_bytes) (may_allocate() ? realloc(old, n_bytes) : NULL)
#define calloc(n, n_bytes) (may_allocate() ? calloc(n, n_bytes) : NULL)

#endif
