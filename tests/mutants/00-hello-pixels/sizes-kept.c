// mutant: the first call's sizes are kept
// task: set_arguments
// caught by: set_arguments-picture
// says: earlier
    static cl_int size[2];
    if (size[0] == 0) {
        size[0] = width;
        size[1] = height;
    }
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof size[0], &size[0]));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof size[1], &size[1]));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
