// What there is to see in lab 09: its own kernel, and those of labs 07 and 05 beside it.
//
// Read next: world.h.
#include "kdtree3d_build.h"
#include "world.h"

static const WorldTree TREE = {.build.spheres = kdtree3d_build, .limits = tree3d_limits};

// As main.c of the lab builds it; and without shadows, where the user wants none.
static const char *mirrors_options(const World *world)
{
    static const char *const OPTIONS[2][2] = {
        {KERNEL_OPTIONS " -DNO_SHADOWS", KERNEL_OPTIONS " -DNO_SHADOWS -DACNE"},
        {KERNEL_OPTIONS, KERNEL_OPTIONS " -DACNE"},
    };
    return OPTIONS[world->has_shadows][world->lab->options.acne];
}

static void set_mirrors(const World *world, cl_kernel kernel, cl_mem d_work)
{
    spheres_set_traced(world, kernel);  // arguments 0 to 12
    CL_CHECK(clSetKernelArg(kernel, 13, sizeof world->n_bounces, &world->n_bounces));
    CL_CHECK(clSetKernelArg(kernel, 14, sizeof d_work, &d_work));
}

static const WorldKernel KERNELS[] = {
    {
        .label = "mirrors",
        .path = LAB_FOLDER "/render_mirrors.cl",
        .function = "render_mirrors",
        .tree = &TREE,
        .options_of = mirrors_options,
        .not_followed = "many rays a pixel: none is followed (N)",
        .set_arguments = set_mirrors,
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
    .what = "Shows spheres with their shadows, and as mirrors.",
    .kind = &SPHERES,
    .set = OPTIONS_MIRRORS,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
