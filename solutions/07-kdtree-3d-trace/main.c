// Lab 07: trace spheres with the kd-tree and save the picture. Nothing to fill in here; compare it
// with lab 05's to see what is new (the tree), then go to clip_to_box.cl, choose_children.cl and
// trace.cl.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps. enqueue_pixels() and
// read_back() are those of lab 00 (render.h).
#include "cl_memory.h"
#include "image.h"
#include "kdtree3d_build.h"
#include "lab.h"
#include "render.h"
#include "scene3d.h"
#include "scene_buffers.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME,
                        "Traces spheres; a ray tests the spheres of the kd-tree cells it meets.",
                        OPTIONS_SCENE3D | OPTIONS_TREE | OPTIONS_DEVICE | OPTIONS_WORK);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_spheres", scene.n_spheres, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    SceneBuffers buffers;
    require(scene_buffers_create(&lab.cl, &scene, &buffers));
    // New in this lab: the tree of lab 06 over the scene's spheres.
    const u32 n_spheres = (u32)scene.n_spheres;
    const KdTreeLimits limits =
        tree3d_limits(lab.options.max_depth, lab.options.leaf_size, n_spheres);
    stats_integer(&lab.stats, "max_depth", limits.maxDepth);
    stats_integer(&lab.stats, "leaf_size", limits.targetElementsPerNode);
    KdTree3D tree;
    const double start = stats_clock_ms();
    require(kdtree3d_build(scene.spheres, n_spheres, limits, &tree));
    stats_number(&lab.stats, "tree.build_ms", stats_clock_ms() - start);
    stats_integer(&lab.stats, "tree.n_nodes", tree.n_nodes);
    stats_integer(&lab.stats, "tree.n_sphere_ids", tree.n_sphere_ids);
    // The kernel follows every id without a check.
    require(tree3d_check(&tree, n_spheres));
    const BBox3D bounds = box_widened(tree.bounds);
    cl_mem d_nodes = cl_buffer_create(&lab.cl, tree.nodes, tree.n_nodes * sizeof(KdNode3));
    cl_mem d_sphere_ids =
        cl_buffer_create(&lab.cl, tree.sphere_ids, tree.n_sphere_ids * sizeof(u32));

    // ---- Kernel ----------------------------------------------------------------------------
    // One kernel draws. If the work is counted, a second one does that, with the same arguments.
    lab_build_kernels(&lab, LAB_FOLDER "/render_kdtree.cl", "render_kdtree", KERNEL_OPTIONS,
                      scene.width, scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        cl_kernel kernel = lab.kernels[i];
        scene_buffers_set(&buffers, &scene, kernel);  // arguments 0 to 9
        CL_CHECK(clSetKernelArg(kernel, 10, sizeof d_nodes, &d_nodes));
        CL_CHECK(clSetKernelArg(kernel, 11, sizeof d_sphere_ids, &d_sphere_ids));
        CL_CHECK(clSetKernelArg(kernel, 12, sizeof bounds, &bounds));
        CL_CHECK(clSetKernelArg(kernel, 13, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_pixels, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, buffers.d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_SPHERES);

    const cl_mem memory[] = {d_nodes, d_sphere_ids};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    scene_buffers_free(&buffers);
    image_free(&image);
    tree3d_free(&tree);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
