// Lab 03: draw circles with the kd-tree and save the picture. Nothing to fill in here; read it
// beside lab 01's, see what is new (the tree's buffers), then go to implicit2DRenderer_KD.cl.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps. enqueue_pixels() and
// read_back() are those of lab 00 (render.h).
#include "cl_memory.h"
#include "image.h"
#include "kdtree2d_build.h"
#include "lab.h"
#include "render.h"
#include "scene2d.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME,
                        "Draws circles; a pixel asks the circles of its kd-tree cell.",
                        OPTIONS_SCENE | OPTIONS_TREE | OPTIONS_DEVICE | OPTIONS_WORK);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene2D scene;
    require(scene2d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_circles", scene.n_circles, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    // New in this lab: the tree of lab 02 over the scene's circles.
    KdTree2D tree;
    const KdTreeLimits limits = {lab.options.max_depth, lab.options.leaf_size};
    const double start = stats_clock_ms();
    require(kdtree2d_build(scene.circles, (u32)scene.n_circles, limits, &tree));
    stats_number(&lab.stats, "tree.build_ms", stats_clock_ms() - start);
    stats_integer(&lab.stats, "tree.n_nodes", tree.n_nodes);
    stats_integer(&lab.stats, "tree.n_map", tree.n_map);
    require(tree2d_check(&tree, (u32)scene.n_circles));  // the kernel follows every id unchecked
    // cl_buffer_create() is lab 01's clCreateBuffer and its check; an empty array becomes one byte.
    cl_mem d_circles = cl_buffer_create(&lab.cl, scene.circles, scene.n_circles * sizeof(Circle));
    cl_mem d_nodes_Relations =
        cl_buffer_create(&lab.cl, tree.nodes_Relations, tree.n_nodes * sizeof(NodeRel));
    cl_mem d_nodes_flag = cl_buffer_create(&lab.cl, tree.nodes_flag, tree.n_nodes * sizeof(u8));
    cl_mem d_nodes_BBox = cl_buffer_create(&lab.cl, tree.nodes_BBox, tree.n_nodes * sizeof(BBox2D));
    cl_mem d_mapNode2Circles =
        cl_buffer_create(&lab.cl, tree.mapNode2Circles, tree.n_map * sizeof(u32));
    cl_mem d_image;
    require(cl_image_create(&lab.cl, scene.width, scene.height, &d_image));

    // ---- Kernel ----------------------------------------------------------------------------
    // One kernel draws. With --stats a second one counts the work, with the same arguments.
    lab_build_kernels(&lab, LAB_FOLDER "/implicit2DRenderer_KD.cl", "implicit2DRenderer_KD",
                      KERNEL_OPTIONS, scene.width, scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        cl_kernel kernel = lab.kernels[i];
        CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_circles, &d_circles));
        CL_CHECK(clSetKernelArg(kernel, 1, sizeof d_nodes_Relations, &d_nodes_Relations));
        CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_nodes_flag, &d_nodes_flag));
        CL_CHECK(clSetKernelArg(kernel, 3, sizeof d_nodes_BBox, &d_nodes_BBox));
        CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_mapNode2Circles, &d_mapNode2Circles));
        CL_CHECK(clSetKernelArg(kernel, 5, sizeof scene.width, &scene.width));
        CL_CHECK(clSetKernelArg(kernel, 6, sizeof scene.height, &scene.height));
        CL_CHECK(clSetKernelArg(kernel, 7, sizeof d_image, &d_image));
        CL_CHECK(clSetKernelArg(kernel, 8, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_pixels, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_CIRCLES);

    const cl_mem memory[] = {d_circles,    d_nodes_Relations, d_nodes_flag,
                             d_nodes_BBox, d_mapNode2Circles, d_image};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    image_free(&image);
    tree2d_free(&tree);
    scene2d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
