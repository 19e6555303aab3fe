// right: a table of sizes and addresses, and a loop
// task: set_arguments
    const cl_int sizes[2] = {width, height};
    for (cl_uint i = 0; i < 2; i++) {
        CL_CHECK(clSetKernelArg(kernel, i, sizeof sizes[i], sizes + i));
    }
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
