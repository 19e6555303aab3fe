// Lab 10, Part A: draw circles tile by tile and save the picture. Nothing to fill in here; read it
// beside lab 03's main.c, see what is new, then go to circle_tile.cl.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps.
#include "circles.h"

#include "circle_tree.h"
#include "cl_memory.h"
#include "scene2d.h"

TileShape circle_tile_shape(cl_device_id device)
{
    TileShape tile = tile_shape(device);
    tile.width = tile.height = tile.lanes;
    return tile;
}

void enqueue_circle_tiles(cl_command_queue queue, cl_kernel kernel, int width, int height)
{
    enqueue_tiles_of(queue, kernel, circle_tile_shape(queue_device(queue)), width, height);
}

void draw_circles(Lab *lab)
{
    // ---- Scene, device ---------------------------------------------------------------------
    Scene2D scene;
    require(scene2d_open(lab->options.scene, lab->options.width, lab->options.height, &scene));
    require(cl_setup_open(lab->options.device, &lab->cl));
    lab_describe(lab, "n_circles", scene.n_circles, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    // New since lab 03: two arrays are all of the tree, and the picture is one of bytes.
    CircleTree tree;
    const int max_depth = lab->options.max_depth, leaf_size = lab->options.leaf_size;
    const KdTreeLimits limits = {max_depth > 0 ? max_depth : OPTIONS_LARGEST_MAX_DEPTH,
                                 leaf_size > 0 ? leaf_size : CIRCLE_LEAF_SIZE};
    const double start = stats_clock_ms();
    require(circle_tree_build(&scene, limits, &tree));
    stats_number(&lab->stats, "tree.build_ms", stats_clock_ms() - start);
    stats_integer(&lab->stats, "tree.n_nodes", tree.n_nodes);
    stats_integer(&lab->stats, "tree.n_leaf_circles", tree.n_leaf_circles);
    cl_mem d_nodes = cl_buffer_create(&lab->cl, tree.nodes, tree.n_nodes * sizeof(TileNode));
    cl_mem d_leaf_circles =
        cl_buffer_create(&lab->cl, tree.leaf_circles, tree.n_leaf_circles * sizeof(TileCircle));
    cl_mem d_pixels = pixels_create(&lab->cl, scene.width, scene.height);

    // ---- Kernel ----------------------------------------------------------------------------
    lab_build_kernels(lab, LAB_FOLDER "/render_circles.cl", "render_circles",
                      circle_tile_shape(lab->cl.device).options, scene.width, scene.height);
    for (int i = 0; i < lab->n_kernels; i++) {
        cl_kernel kernel = lab->kernels[i];
        CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_nodes, &d_nodes));
        CL_CHECK(clSetKernelArg(kernel, 1, sizeof d_leaf_circles, &d_leaf_circles));
        CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene.width, &scene.width));
        CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene.height, &scene.height));
        CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_pixels, &d_pixels));
        CL_CHECK(clSetKernelArg(kernel, 5, sizeof lab->d_work[i], &lab->d_work[i]));
    }
    lab_draw(lab, enqueue_circle_tiles, lab->kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    pixels_read(lab->cl.queue, d_pixels, &image);
    require(image_save(&image, lab->options.output));
    // Each pixel counts what its tile did for all of its pixels.
    lab_count_work(lab, enqueue_circle_tiles, scene.width, scene.height, WORK_CIRCLES);

    const cl_mem memory[] = {d_nodes, d_leaf_circles, d_pixels};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    image_free(&image);
    circle_tree_free(&tree);
    scene2d_free(&scene);
}
