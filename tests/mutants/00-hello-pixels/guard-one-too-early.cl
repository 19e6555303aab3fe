// mutant: the guard leaves out the last column and the last row
// task: gradient
// caught by: gradient-picture
// says: nobody wrote
// looks: unwritten
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width - 1 || y >= height - 1) {
        return;
    }
    const float red = (float)x / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
