// Lab 04: make a ray for every pixel and draw its direction. Nothing to fill in here; read it from
// top to bottom once, then go to camera_from_view.c and primary_ray.cl.
//
// Flow: scene (only its view) -> buffers -> kernel -> image; the banners below name the steps.
// enqueue_pixels() and read_back() are those of lab 00 (render.h).
#include "camera_from_view.h"
#include "cl_memory.h"
#include "image.h"
#include "lab.h"
#include "render.h"
#include "scene3d.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME, "Draws the directions of the rays as colours.",
                        OPTIONS_SCENE3D | OPTIONS_DEVICE);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, NULL, 0, scene.width, scene.height);
    stats_number(&lab.stats, "fov", scene3d_fov(&scene.view, scene.width, scene.height));

    // ---- Buffers ---------------------------------------------------------------------------
    // The camera is small: it goes along as an argument.
    const Camera camera = camera_from_view(scene.view, scene.width, scene.height);
    cl_mem d_image;
    require(cl_image_create(&lab.cl, scene.width, scene.height, &d_image));

    // ---- Kernel ----------------------------------------------------------------------------
    lab_build_kernels(&lab, LAB_FOLDER "/draw_directions.cl", "draw_directions", KERNEL_OPTIONS,
                      scene.width, scene.height);
    cl_kernel kernel = lab.kernels[LAB_DRAWS];
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof camera, &camera));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene.width, &scene.width));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene.height, &scene.height));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof d_image, &d_image));
    lab_draw(&lab, enqueue_pixels, kernel, scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));

    cl_memory_release(&d_image, 1);
    image_free(&image);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
