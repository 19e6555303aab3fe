// mutant: the width is handed over with the size of a size_t
// task: set_arguments
// caught by: set_arguments-picture
// says: CL_INVALID_ARG_SIZE
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof(size_t), &width));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof height, &height));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
