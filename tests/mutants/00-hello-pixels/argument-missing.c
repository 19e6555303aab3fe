// mutant: the image is never handed over
// task: set_arguments
// caught by: set_arguments-picture
// says: CL_INVALID_KERNEL_ARGS.*three parameters
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof width, &width));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof height, &height));
    (void)d_image;
