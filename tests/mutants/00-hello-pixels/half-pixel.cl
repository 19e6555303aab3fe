// mutant: the sample point is the pixel's centre instead of its integer coordinate
// task: gradient
// caught by: gradient-picture
// says: found
// looks: shifted-half
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (x + 0.5f) / width;
    const float green = (y + 0.5f) / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
