// Memory objects as malloc() gives them (native_cl.h).
#include "native_cl.h"

#include <stdlib.h>

// Vectors of 16 floats lie at multiples of this.
#define ALIGNMENT 64

void *memory_new(size_t n_bytes)
{
    void *bytes = NULL;
    return posix_memalign(&bytes, ALIGNMENT, n_bytes) == 0 ? bytes : NULL;
}

void memory_free(void *bytes, size_t n_bytes)
{
    (void)n_bytes;
    free(bytes);
}

void memory_was_set(const void *bytes, size_t n_bytes)
{
    (void)bytes, (void)n_bytes;
}

void program_begins(void)
{
}

void launch_has_ended(void)
{
}
