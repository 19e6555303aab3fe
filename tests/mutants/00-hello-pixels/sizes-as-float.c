// mutant: sizes are handed over as float
// task: set_arguments
// caught by: set_arguments-picture
// says: float
    const float w = (float)width;
    const float h = (float)height;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof(w), &w));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof(h), &h));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof(cl_mem), &d_image));
