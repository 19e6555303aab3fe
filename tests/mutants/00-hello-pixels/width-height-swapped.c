// mutant: height is handed over first, then width
// task: set_arguments
// caught by: set_arguments-picture
// says: height comes before width
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof height, &height));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof width, &width));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
