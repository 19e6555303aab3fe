// Lab 09: trace spheres with shadows and mirrors and save the picture. Nothing to fill in here: see
// what is new since lab 07's, then go to leave_surface.cl, shadows.cl and mirrors.cl.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps. enqueue_pixels() and
// read_back() are those of lab 00 (render.h).
#include "image.h"
#include "kdtree3d_build.h"
#include "lab.h"
#include "render.h"
#include "scene3d.h"
#include "scene_buffers.h"
#include "tree_buffers.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab =
        lab_begin(argc, argv, LAB_NAME, "Traces spheres with their shadows, and as mirrors.",
                  OPTIONS_SCENE3D | OPTIONS_TREE | OPTIONS_DEVICE | OPTIONS_WORK | OPTIONS_MIRRORS);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_spheres", scene.n_spheres, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    SceneBuffers buffers;
    require(scene_buffers_create(&lab.cl, &scene, &buffers));
    TreeBuffers tree;
    const KdTreeLimits limits =
        tree3d_limits(lab.options.max_depth, lab.options.leaf_size, (u32)scene.n_spheres);
    require(tree_buffers_create(&lab, &scene, "tree", kdtree3d_build, limits, &tree));
    stats_integer(&lab.stats, "max_bounces", lab.options.n_bounces);

    // ---- Kernel ----------------------------------------------------------------------------
    // One kernel draws. Where the work is counted, a second one does that, with the same arguments.
    lab_build_kernels(&lab, LAB_FOLDER "/render_mirrors.cl", "render_mirrors",
                      lab.options.acne ? KERNEL_OPTIONS " -DACNE" : KERNEL_OPTIONS, scene.width,
                      scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        cl_kernel kernel = lab.kernels[i];
        scene_buffers_set(&buffers, &scene, kernel);  // arguments 0 to 9
        tree_buffers_set(&tree, kernel);              // 10 to 12
        CL_CHECK(clSetKernelArg(kernel, 13, sizeof lab.options.n_bounces, &lab.options.n_bounces));
        CL_CHECK(clSetKernelArg(kernel, 14, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_pixels, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, buffers.d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_SPHERES);

    tree_buffers_free(&tree);
    scene_buffers_free(&buffers);
    image_free(&image);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
