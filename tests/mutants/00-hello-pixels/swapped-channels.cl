// mutant: red grows downwards and green to the right
// task: gradient
// caught by: gradient-picture
// says: red and green swapped
// looks: channels-swapped
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)y / height;
    const float green = (float)x / width;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
