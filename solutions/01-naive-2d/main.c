// Lab 01: draw circles the naive way and save the picture. Nothing to fill in here; read it from
// top to bottom once, then go to overlaps_N_Nearer.cl and implicit2DRenderer.cl.
//
// Flow: scene -> buffers -> kernel -> image; the banners below name the steps. enqueue_pixels() and
// read_back() are those of lab 00 (render.h).
#include "cl_memory.h"
#include "image.h"
#include "lab.h"
#include "render.h"
#include "scene2d.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME, "Draws circles; every pixel asks every circle.",
                        OPTIONS_SCENE | OPTIONS_DEVICE | OPTIONS_WORK);

    // ---- Scene, device ---------------------------------------------------------------------
    Scene2D scene;
    require(scene2d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, "n_circles", scene.n_circles, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    // OpenCL has no empty buffers: for a scene without circles the kernel gets NULL.
    cl_mem d_circles = NULL;
    if (scene.n_circles > 0) {
        cl_int error;
        d_circles =
            clCreateBuffer(lab.cl.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                           (size_t)scene.n_circles * sizeof *scene.circles, scene.circles, &error);
        CL_CHECK_CREATED(error, clCreateBuffer);
    }
    cl_mem d_image;
    require(cl_image_create(&lab.cl, scene.width, scene.height, &d_image));

    // ---- Kernel ----------------------------------------------------------------------------
    // One kernel draws. With --stats a second one counts the work, with the same arguments.
    lab_build_kernels(&lab, LAB_FOLDER "/implicit2DRenderer.cl", "implicit2DRenderer",
                      KERNEL_OPTIONS, scene.width, scene.height);
    for (int i = 0; i < lab.n_kernels; i++) {
        cl_kernel kernel = lab.kernels[i];
        CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_circles, &d_circles));
        CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene.n_circles, &scene.n_circles));
        CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene.width, &scene.width));
        CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene.height, &scene.height));
        CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_image, &d_image));
        CL_CHECK(clSetKernelArg(kernel, 5, sizeof lab.d_work[i], &lab.d_work[i]));
    }
    lab_draw(&lab, enqueue_pixels, lab.kernels[LAB_DRAWS], scene.width, scene.height);

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(image_create(scene.width, scene.height, &image));
    read_back(lab.cl.queue, d_image, scene.width, scene.height, image.pixels);
    require(image_save(&image, lab.options.output));
    lab_count_work(&lab, enqueue_pixels, scene.width, scene.height, WORK_CIRCLES);

    const cl_mem memory[] = {d_circles, d_image};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    image_free(&image);
    scene2d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
