// Memory for worlds (see world.h).
//
// Flow: SCENE -> BUFFERS -> KERNEL -> image -> comparison. Read next: circles.c, spheres.c.
#include "world.h"

#include "complain.h"

void *world_allocate(size_t n_bytes)
{
    void *memory = calloc(1, n_bytes);
    if (memory == NULL) {
        complain("view: no memory for %zu bytes", n_bytes);
        exit(EXIT_FAILURE);
    }
    return memory;
}
