// Lab 05: trace spheres the naive way and save the picture. Nothing to fill in here; read it from
// top to bottom once, then go to intersect_sphere.cl, nearest_hit.cl and shade.cl.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps. enqueue_pixels() and
// read_back() are those of lab 00 (render.h).
#include "image.h"
#include "lab.h"
#include "render.h"
#include "scene3d.h"
#include "scene_buffers.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME, "Traces spheres; every ray tests every sphere.",
                        OPTIONS_SCENE3D | OPTIONS_DEVICE | OPTIONS_WORK | OPTIONS_TEXTBOOK);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_spheres", scene.n_spheres, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    SceneBuffers buffers;
    require(scene_buffers_create(&lab.cl, &scene, &buffers));

    // ---- Kernel ----------------------------------------------------------------------------
    // One kernel draws. If the work is counted, a second one does that, with the same arguments.
    lab_build_kernels(&lab, LAB_FOLDER "/render_spheres.cl", "render_spheres",
                      lab.options.textbook ? KERNEL_OPTIONS " -DTEXTBOOK" : KERNEL_OPTIONS,
                      scene.width, scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        cl_kernel kernel = lab.kernels[i];
        scene_buffers_set(&buffers, &scene, kernel);  // arguments 0 to 9
        CL_CHECK(clSetKernelArg(kernel, 10, sizeof scene.n_spheres, &scene.n_spheres));
        CL_CHECK(clSetKernelArg(kernel, 11, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_pixels, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, buffers.d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_SPHERES);

    scene_buffers_free(&buffers);
    image_free(&image);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
