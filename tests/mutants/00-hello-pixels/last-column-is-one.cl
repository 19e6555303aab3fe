// mutant: the sizes are made one smaller, so that the last column reaches 1
// task: gradient
// caught by: gradient-picture
// says: found
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)x / (width - 1);
    const float green = (float)y / (height - 1);
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
