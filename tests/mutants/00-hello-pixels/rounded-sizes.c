// mutant: the rounded-up sizes are handed over
// task: set_arguments
// caught by: set_arguments-picture
// says: rounded
    const cl_int w = (width + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
    const cl_int h = (height + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof w, &w));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof h, &h));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
