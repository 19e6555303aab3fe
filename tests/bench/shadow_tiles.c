// Shadow rays, tile by tile (see shadow_tiles.h).
//
// Read next: shadow_tiles.cl.
#include "shadow_tiles.h"

#include "launch.h"

#include <stdio.h>

// The arguments that each light has its own of.
enum { POSITION_ARGUMENT = 5, FIRST_RAY_ARGUMENT, N_RAYS_ARGUMENT };

// Build the kernel, for tiles of the device's shape. Returns 0, or -1 after one message.
static int build_kernel(ShadowTiles *tiles, const ClSetup *cl)
{
    const TileShape shape = tile_shape(cl->device);
    tiles->rays_a_tile = shape.width * shape.height;
    tiles->group_tiles = shape.group_side * shape.group_side;
    // Its options name the folders of the labs before.
    char options[2048];
    snprintf(options, sizeof options, "%s -I solutions/10-realtime", shape.options);
    cl_program program = cl_setup_build(cl, "tests/bench/shadow_tiles.cl", options);
    if (program == NULL) {
        return -1;
    }
    tiles->kernel = kernel_create(program, "search_shadow_tiles");
    CL_CHECK(clReleaseProgram(program));
    return 0;
}

// Queue a search of the first n_rays rays of a light, rounded up to whole work-groups' tiles.
static void enqueue_light(const ShadowTiles *tiles, const ClSetup *cl, int light, int n_rays)
{
    if (n_rays == 0) {
        return;
    }
    const size_t rays_a_group = tiles->group_tiles * (size_t)tiles->rays_a_tile;
    const size_t n_groups = ((size_t)n_rays + rays_a_group - 1) / rays_a_group;
    const size_t local_size = tiles->group_tiles;
    const size_t global_size = n_groups * local_size;
    const Vec3 position = tiles->lights[light].position;
    const int first_ray = tiles->light_starts[light];
    CL_CHECK(clSetKernelArg(tiles->kernel, POSITION_ARGUMENT, sizeof position, &position));
    CL_CHECK(clSetKernelArg(tiles->kernel, FIRST_RAY_ARGUMENT, sizeof first_ray, &first_ray));
    CL_CHECK(clSetKernelArg(tiles->kernel, N_RAYS_ARGUMENT, sizeof n_rays, &n_rays));
    CL_CHECK(clEnqueueNDRangeKernel(cl->queue, tiles->kernel, 1, NULL, &global_size, &local_size, 0,
                                    NULL, NULL));
}

static int count_rays(const ShadowTiles *tiles, int light)
{
    return tiles->light_starts[light + 1] - tiles->light_starts[light];
}

int shadow_tiles_prepare(ShadowTiles *tiles, const ClSetup *cl, const Case3D *bench_case,
                         const int *light_starts, cl_mem d_rays, cl_mem d_answers)
{
    const TileBuffers *tree = &bench_case->tiles;
    tiles->lights = bench_case->scene.lights;
    tiles->n_lights = bench_case->scene.n_lights;
    tiles->light_starts = light_starts;
    if (build_kernel(tiles, cl) != 0) {
        return -1;
    }
    cl_kernel kernel = tiles->kernel;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof tree->d_nodes, &tree->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof tree->bounds, &tree->bounds));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof tree->d_leaf_spheres, &tree->d_leaf_spheres));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof d_rays, &d_rays));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_answers, &d_answers));
    // The driver may compile at the first launch.
    enqueue_light(tiles, cl, 0, count_rays(tiles, 0) > 0 ? 1 : 0);
    CL_CHECK(clFinish(cl->queue));
    return 0;
}

void shadow_tiles_free(ShadowTiles *tiles)
{
    if (tiles->kernel != NULL) {
        CL_CHECK(clReleaseKernel(tiles->kernel));
    }
}

void shadow_tiles_search(const ShadowTiles *tiles, const ClSetup *cl)
{
    for (int light = 0; light < tiles->n_lights; light++) {
        enqueue_light(tiles, cl, light, count_rays(tiles, light));
    }
    CL_CHECK(clFinish(cl->queue));
}
