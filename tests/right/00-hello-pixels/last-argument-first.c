// right: the arguments from the last to the first, their sizes by type
// task: set_arguments
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof(cl_mem), &d_image));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof(cl_int), &height));
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof(cl_int), &width));
