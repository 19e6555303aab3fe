// mutant: a copied line: the width is handed over twice
// task: set_arguments
// caught by: set_arguments-picture
// says: width is there twice
    (void)height;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof width, &width));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof width, &width));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
