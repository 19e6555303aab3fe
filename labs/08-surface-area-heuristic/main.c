// Lab 08: trace spheres with two kd-trees, lab 06's and one that is built by cost, and compare what
// a ray costs. Nothing to fill in here; read it beside lab 07's, then go to kdtree3d_sah.c.
//
// Flow: scene -> buffers -> kernel (lab 07's) -> image; the banners below name the steps.
#include "image.h"
#include "kdtree3d_build.h"
#include "kdtree3d_sah.h"
#include "lab.h"
#include "render.h"
#include "scene_buffers.h"
#include "tree_buffers.h"
#include "tree_report.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(
        argc, argv, LAB_NAME,
        "Traces spheres with a kd-tree that is built by cost, and compares it with lab 06's.",
        OPTIONS_SCENE3D | OPTIONS_TREE | OPTIONS_DEVICE | OPTIONS_WORK);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_spheres", scene.n_spheres, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    SceneBuffers buffers;
    require(scene_buffers_create(&lab.cl, &scene, &buffers));
    const int max_depth = lab.options.max_depth, leaf_size = lab.options.leaf_size;
    TreeBuffers middle, by_cost;
    require(tree_buffers_create(&lab, &scene, "middle", kdtree3d_build,
                                tree3d_limits(max_depth, leaf_size, (u32)scene.n_spheres),
                                &middle));
    // Cost knows by itself where to stop: what limits the other tree is the todo stack alone.
    const KdTreeLimits limits = {max_depth > 0 ? max_depth : TODO_SIZE + 1,
                                 leaf_size > 0 ? leaf_size : 1};
    require(tree_buffers_create(&lab, &scene, "by_cost", kdtree3d_build_sah, limits, &by_cost));

    // ---- Kernel ----------------------------------------------------------------------------
    lab_build_kernels(&lab, "solutions/07-kdtree-3d-trace/render_kdtree.cl", "render_kdtree",
                      KERNEL_OPTIONS, scene.width, scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        scene_buffers_set(&buffers, &scene, lab.kernels[i]);  // arguments 0 to 9
        tree_buffers_set(&by_cost, lab.kernels[i]);           // 10 to 12
        CL_CHECK(clSetKernelArg(lab.kernels[i], 13, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_pixels, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, buffers.d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_SPHERES);
    if (lab.n_kernels > LAB_COUNTS) {
        tree_buffers_set(&middle, lab.kernels[LAB_COUNTS]);
    }
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_SPHERES_MIDDLE);

    tree_buffers_free(&middle);
    tree_buffers_free(&by_cost);
    scene_buffers_free(&buffers);
    image_free(&image);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
