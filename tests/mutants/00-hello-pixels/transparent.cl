// mutant: alpha is 0
// task: gradient
// caught by: gradient-picture
// says: found \([^)]*, *0(\.0*)?\)
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)x / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 0.0f));
