// mutant: green is a quotient of whole numbers
// task: gradient
// caught by: gradient-picture
// says: green is 0
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = x / (float)width;
    const float green = y / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
