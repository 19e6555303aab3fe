// mutant: column 0 is taken for the right one
// task: gradient
// caught by: gradient-picture
// says: mirrored
// looks: mirrored-x
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)x / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(width - 1 - x, y), (float4)(red, green, 0.25f, 1.0f));
