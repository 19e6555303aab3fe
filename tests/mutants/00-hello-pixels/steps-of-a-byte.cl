// mutant: red and green in 255 steps
// task: gradient
// caught by: gradient-picture
// says: 255
    int x = get_global_id(0);
    int y = get_global_id(1);
    if (x >= width || y >= height)
        return;
    float red = (float)(255 * x / width) / 255.0f;
    float green = (float)(255 * y / height) / 255.0f;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
