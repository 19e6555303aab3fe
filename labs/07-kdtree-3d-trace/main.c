// Lab 07: trace spheres with the kd-tree and save the picture. Nothing to fill in here; read it
// beside lab 05's, see what is new (the tree), then go to clip_to_box.cl, choose_children.cl and
// trace.cl.
//
// Flow: scene -> buffers -> kernel -> image -> comparison; the banners below name the steps.
// enqueue_pixels() and read_back() are those of lab 00 (render.h).
#include "cl_memory.h"
#include "cl_setup.h"
#include "frames.h"
#include "image.h"
#include "kdtree3d_build.h"
#include "options.h"
#include "render.h"
#include "scene3d.h"
#include "scene_buffers.h"
#include "stats.h"
#include "work_stats.h"

#include <math.h>
#include <stdlib.h>

// The packed tree on the device.
typedef struct TreeBuffers {
    cl_mem d_nodes;
    cl_mem d_sphere_ids;
    BBox3D bounds;  // goes along as it is
} TreeBuffers;

// The root's cell is rounded: at 100 000 a float's steps are 1/128, and a sphere may reach up to
// half a step out of it. A step more on each side holds every sphere whole.
static BBox3D box_widened(BBox3D box)
{
    for (int axis = 0; axis < 3; axis++) {
        box.min[axis] = nextafterf(box.min[axis], -INFINITY);
        box.max[axis] = nextafterf(box.max[axis], INFINITY);
    }
    return box;
}

// Build the tree and copy it to the device. Returns 0, or -1 after one message.
static int create_tree(const ClSetup *cl, const Options *options, const Scene3D *scene,
                       TreeBuffers *buffers, Stats *stats)
{
    const u32 n_spheres = (u32)scene->n_spheres;
    const KdTreeLimits limits = tree3d_limits(options->max_depth, options->leaf_size, n_spheres);
    KdTree3D tree = {0};
    const double start = stats_clock_ms();
    if (kdtree3d_build(scene->spheres, n_spheres, limits, &tree) != 0) {
        return -1;
    }
    stats_integer(stats, "max_depth", limits.maxDepth);
    stats_integer(stats, "leaf_size", limits.targetElementsPerNode);
    stats_number(stats, "tree.build_ms", stats_clock_ms() - start);
    // The kernel follows every id without asking.
    if (tree3d_check(&tree, n_spheres) != 0) {
        tree3d_free(&tree);
        return -1;
    }
    stats_integer(stats, "tree.n_nodes", tree.n_nodes);
    stats_integer(stats, "tree.n_sphere_ids", tree.n_sphere_ids);
    buffers->d_nodes = cl_buffer_create(cl, tree.nodes, tree.n_nodes * sizeof *tree.nodes);
    buffers->d_sphere_ids =
        cl_buffer_create(cl, tree.sphere_ids, tree.n_sphere_ids * sizeof *tree.sphere_ids);
    buffers->bounds = box_widened(tree.bounds);
    tree3d_free(&tree);
    return 0;
}

// Build the program and draw n_frames with it.
//   d_work   counters, or NULL when nothing is counted
// Returns 0, or -1 after one message.
static int draw(const ClSetup *cl, const Scene3D *scene, const SceneBuffers *buffers,
                const TreeBuffers *tree, const char *build_options, cl_mem d_work, int n_frames,
                Stats *stats)
{
    // ---- Program ---------------------------------------------------------------------------
    cl_program program = cl_setup_build(cl, LAB_FOLDER "/render_kdtree.cl", build_options);
    if (program == NULL) {
        return -1;
    }

    // ---- Kernel ----------------------------------------------------------------------------
    cl_int error;
    cl_kernel kernel = clCreateKernel(program, "render_kdtree", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    scene_buffers_set(buffers, scene, kernel);
    cl_uint argument = N_SCENE_ARGUMENTS;
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof tree->d_nodes, &tree->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof tree->d_sphere_ids, &tree->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof tree->bounds, &tree->bounds));
    if (d_work != NULL) {
        CL_CHECK(clSetKernelArg(kernel, argument, sizeof d_work, &d_work));
    }
    frames_draw(cl, enqueue_pixels, kernel, scene->width, scene->height, n_frames, stats);

    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    return 0;
}

// Draw with a kernel that counts the work of each pixel. Returns 0, or -1 after one message.
static int count_work(const ClSetup *cl, const Options *options, const Scene3D *scene,
                      const SceneBuffers *buffers, const TreeBuffers *tree, Stats *stats)
{
    // Counting slows a kernel down: its time is not among the figures.
    Stats counting_times = {0};
    cl_mem d_work = work_buffer_create(cl, scene->width, scene->height);
    int result =
        draw(cl, scene, buffers, tree, KERNEL_OPTIONS " -DCOUNT_WORK", d_work, 1, &counting_times);
    if (result == 0) {
        result = work_report(cl, d_work, scene->width, scene->height, WORK_SPHERES,
                             options->heat_map ? options->output : NULL, stats);
    }
    stats_free(&counting_times);
    CL_CHECK(clReleaseMemObject(d_work));
    return result;
}

// From the open device to the picture in the host's memory. Returns 0, or -1 after one message.
static int render(const ClSetup *cl, const Options *options, const Scene3D *scene, Image *image,
                  Stats *stats)
{
    // ---- Buffers ---------------------------------------------------------------------------
    SceneBuffers buffers;
    if (scene_buffers_create(cl, scene, &buffers) != 0) {
        return -1;
    }

    // ---- Tree ------------------------------------------------------------------------------
    TreeBuffers tree = {0};
    int result = create_tree(cl, options, scene, &tree, stats);
    if (result == 0 && (options->stats != NULL || options->heat_map)) {
        result = count_work(cl, options, scene, &buffers, &tree, stats);
    }
    if (result == 0) {
        result = draw(cl, scene, &buffers, &tree, KERNEL_OPTIONS, NULL, options->n_frames, stats);
    }

    // ---- Image -----------------------------------------------------------------------------
    if (result == 0) {
        read_back(cl->queue, buffers.d_image, scene->width, scene->height, image->pixels);
    }
    if (tree.d_nodes != NULL) {
        CL_CHECK(clReleaseMemObject(tree.d_nodes));
        CL_CHECK(clReleaseMemObject(tree.d_sphere_ids));
    }
    scene_buffers_free(&buffers);
    return result;
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Options options;
    switch (options_parse(argc, argv, LAB_NAME,
                          "Traces spheres; a ray asks the spheres of the kd-tree cells it meets.",
                          OPTIONS_SCENE3D | OPTIONS_TREE | OPTIONS_DEVICE | OPTIONS_WORK,
                          &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }

    // ---- Scene, device ---------------------------------------------------------------------
    ClSetup cl = {0};
    Scene3D scene = {0};
    Image image = {0};
    Stats stats = {0};
    int result = scene3d_open(options.scene, options.width, options.height, &scene);
    if (result == 0) {
        result = cl_setup_open(options.device, &cl);
    }
    if (result == 0) {
        stats_text(&stats, "lab", LAB_NAME);
        stats_text(&stats, "device", cl.device_name);
        stats_text(&stats, "scene", options.scene);
        stats_integer(&stats, "n_spheres", scene.n_spheres);
        stats_integer(&stats, "width", scene.width);
        stats_integer(&stats, "height", scene.height);
        result = image_create(scene.width, scene.height, &image);
    }

    // ---- Buffers, kernel, image ------------------------------------------------------------
    if (result == 0) {
        result = render(&cl, &options, &scene, &image, &stats);
    }
    if (result == 0) {
        result = image_save(&image, options.output);
    }
    if (result == 0) {
        result = stats_report(&stats, options.stats);
    }
    stats_free(&stats);
    image_free(&image);
    scene3d_free(&scene);
    cl_setup_close(&cl);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
