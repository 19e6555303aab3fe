// Lab 00: draw a gradient and save it. Nothing to fill in here; read it from top to bottom once,
// then go to render.c (host) and gradient.cl (device).
//
// Flow: [no scene] -> buffers -> kernel -> image; the banners below name the steps, the same in
// every lab.
#include "cl_memory.h"
#include "image.h"
#include "lab.h"
#include "render.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME, "Draws a colour gradient.", OPTIONS_DEVICE);

    // ---- Scene, device ---------------------------------------------------------------------
    // A gradient is no scene: there is only the picture's size.
    const int width = lab.options.width ? lab.options.width : OPTIONS_DEFAULT_WIDTH;
    const int height = lab.options.height ? lab.options.height : OPTIONS_DEFAULT_HEIGHT;
    require(cl_setup_open(lab.options.device, &lab.cl));
    lab_describe(&lab, NULL, 0, width, height);

    // ---- Buffers ---------------------------------------------------------------------------
    Image image;
    require(cl_image_check_size(&lab.cl, width, height));
    require(image_create(width, height, &image));
    const cl_image_format format = {CL_RGBA, CL_FLOAT};
    const cl_image_desc desc = {.image_type = CL_MEM_OBJECT_IMAGE2D,
                                .image_width = (size_t)width,
                                .image_height = (size_t)height};
    // New memory has unknown contents, so the image begins as a copy of the host's, which is black.
    // A pixel that no work-item writes stays black.
    cl_int error;
    cl_mem d_image = clCreateImage(lab.cl.context, CL_MEM_WRITE_ONLY | CL_MEM_COPY_HOST_PTR,
                                   &format, &desc, image.pixels, &error);
    CL_CHECK_CREATED(error, clCreateImage);

    // ---- Kernel ----------------------------------------------------------------------------
    cl_program program = lab_build_program(&lab, LAB_FOLDER "/gradient.cl", KERNEL_OPTIONS);
    cl_kernel kernel = clCreateKernel(program, "gradient", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    set_arguments(kernel, width, height, d_image);
    lab_draw(&lab, enqueue_pixels, kernel, width, height);

    // ---- Image -----------------------------------------------------------------------------
    read_back(lab.cl.queue, d_image, width, height, image.pixels);
    require(image_save(&image, lab.options.output));

    CL_CHECK(clReleaseMemObject(d_image));
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    image_free(&image);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
