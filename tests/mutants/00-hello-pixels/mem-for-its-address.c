// mutant: the cl_mem itself is handed over where its address is wanted
// task: set_arguments
// caught by: set_arguments-picture
// says: crash.*set_arguments|CL_INVALID_MEM_OBJECT
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof width, &width));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof height, &height));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, d_image));
