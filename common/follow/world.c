// Opening worlds, and memory for them (see world.h).
//
// Flow: SCENE -> BUFFERS -> KERNEL -> image -> comparison. Read next: circles.c, spheres.c.
#include "world.h"

#include "complain.h"

int world_open(World *world, Lab *lab, const WorldLab *world_lab)
{
    *world = (World){.lab = lab,
                     .kind = world_lab->kind,
                     .build = world_lab->build,
                     .has_tree = world_lab->has_tree,
                     .has_shadows = 1,
                     .n_bounces = lab->options.n_bounces};
    return cl_setup_open(lab->options.device, &lab->cl) == 0 ? world->kind->open(world) : -1;
}

int world_options(const WorldLab *world_lab)
{
    return world_lab->kind->set | world_lab->set | (world_lab->has_tree ? OPTIONS_TREE : 0) |
           OPTIONS_DEVICE;
}

const char *world_kernel_options(const World *world, const WorldKernel *kernel)
{
    return kernel->options_of != NULL ? kernel->options_of(world) : kernel->options;
}

void *world_allocate(size_t n_bytes)
{
    void *memory = calloc(1, n_bytes);
    if (memory == NULL) {
        complain("no memory for %zu bytes", n_bytes);
        exit(EXIT_FAILURE);
    }
    return memory;
}
