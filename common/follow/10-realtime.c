// What there is to see in lab 10: its tiles of rays, without shadows and with them, and the kernels
// of labs 07 and 05 beside them.
//
// Read next: world.h, and the lab's tile_buffers.h.
#include "kdtree3d_build.h"
#include "kdtree3d_sah.h"
#include "tile_buffers.h"
#include "world_spheres.h"

// ---- Tiles --------------------------------------------------------------------------------------

static KdTreeLimits tiles_limits(int max_depth, int leaf_size, u32 n_elements)
{
    (void)n_elements;
    return tile_tree_limits(max_depth, leaf_size);
}

static void tiles_complete(World *world)
{
    Spheres *own = world->own;
    own->d_leaf_spheres = leaf_spheres_create(world->lab, &own->scene, &own->tree);
    require(own->d_leaf_spheres != NULL ? 0 : -1);
    own->d_pixels = pixels_create(&world->lab->cl, world->width, world->height);
}

static const char *tiles_options(const World *world)
{
    return tile_shape(world->lab->cl.device).options;
}

// As above, and without shadows where the user wants none.
static const char *lit_options(const World *world)
{
    static char without[1024];
    const char *options = tiles_options(world);
    snprintf(without, sizeof without, "%s -DNO_SHADOWS", options);
    return world->has_shadows ? options : without;
}

// All arguments but the last ones.
static void set_scene(const World *world, cl_kernel kernel)
{
    const Spheres *own = world->own;
    const TileBuffers buffers = {
        .scene = own->buffers,
        .d_nodes = own->d_nodes,
        .d_sphere_ids = own->d_sphere_ids,
        .d_leaf_spheres = own->d_leaf_spheres,
        .bounds = own->bounds,
        .d_pixels = own->d_pixels,
    };
    tile_buffers_set(&buffers, &own->scene, kernel);
}

static void set_tiles(const World *world, cl_kernel kernel, cl_mem d_work)
{
    set_scene(world, kernel);  // arguments 0 to 13
    CL_CHECK(clSetKernelArg(kernel, 14, sizeof d_work, &d_work));
}

static void set_lit_tiles(const World *world, cl_kernel kernel, cl_mem d_work)
{
    set_scene(world, kernel);  // arguments 0 to 13
    CL_CHECK(clSetKernelArg(kernel, 14, sizeof world->n_bounces, &world->n_bounces));
    CL_CHECK(clSetKernelArg(kernel, 15, sizeof d_work, &d_work));
}

static void read_tiles(const World *world, Image *picture)
{
    const Spheres *own = world->own;
    pixels_read(world->lab->cl.queue, own->d_pixels, picture);
}

// ---- What is seen -------------------------------------------------------------------------------

static const WorldTree TILES_TREE = {
    .build.spheres = kdtree3d_build_sah,
    .limits = tiles_limits,
    .complete = tiles_complete,
};
static const WorldTree TREE = {.build.spheres = kdtree3d_build, .limits = tree3d_limits};

static const WorldKernel KERNELS[] = {
    {
        .label = "fast, by tiles",
        .path = LAB_FOLDER "/render_tiles.cl",
        .function = "render_tiles",
        .tree = &TILES_TREE,
        .options_of = tiles_options,
        .not_followed = "rays go as tiles: none is followed (N)",
        .set_arguments = set_tiles,
        .enqueue = enqueue_tiles,
        .read = read_tiles,
        .unit = "tile",
    },
    {
        .label = "shadows, by tiles",
        .path = LAB_FOLDER "/render_lit_tiles.cl",
        .function = "render_lit_tiles",
        .tree = &TILES_TREE,
        .options_of = lit_options,
        .not_followed = "rays go as tiles: none is followed (N)",
        .set_arguments = set_lit_tiles,
        .enqueue = enqueue_tiles,
        .read = read_tiles,
        .unit = "tile",
        .has_bounces = 1,
    },
    {
        .label = "kd-tree",
        .path = "solutions/07-kdtree-3d-trace/render_kdtree.cl",
        .function = "render_kdtree",
        .tree = &TREE,
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/07-kdtree-3d-trace.cl",
        .set_arguments = spheres_set_tree,
    },
    SPHERES_NAIVE_KERNEL,
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows spheres; a tile of rays goes through the kd-tree as one.",
    .kind = &SPHERES,
    .set = OPTIONS_SHADOWS,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
