// Opening worlds, and memory for them (see world.h).
//
// Read next: circles.c, rays.c, spheres.c.
#include "world.h"

#include "complain.h"

int world_open(World *world, Lab *lab, const WorldLab *world_lab)
{
    *world = (World){
        .lab = lab, .kind = world_lab->kind, .has_shadows = 1, .n_bounces = lab->options.n_bounces};
    if (cl_setup_open(lab->options.device, &lab->cl) != 0 || world->kind->open(world) != 0) {
        return -1;
    }
    const WorldTree *tree = world_lab->kernels[0].tree;
    return tree != NULL ? world_grow(world, tree, lab->options.max_depth) : 0;
}

int world_grow(World *world, const WorldTree *tree, int max_depth)
{
    const World before = *world;
    const int leaf_size = world->lab->options.leaf_size;
    world->tree = tree;
    world->max_depth = max_depth;
    world->limits = tree->limits != NULL
                        ? tree->limits(max_depth, leaf_size, (u32)world->n_elements)
                        : (KdTreeLimits){max_depth, leaf_size};
    if (world->kind->grow(world) == 0) {
        return 0;
    }
    *world = before;
    return -1;
}

int world_options(const WorldLab *world_lab)
{
    return world_lab->kind->set | world_lab->set |
           (world_lab->kernels[0].tree != NULL ? OPTIONS_TREE : 0) | OPTIONS_DEVICE;
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
