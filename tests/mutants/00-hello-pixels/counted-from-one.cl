// mutant: columns are counted from 1 in the colour
// task: gradient
// caught by: gradient-picture
// says: shifted by one pixel
// looks: shifted-one
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)(x + 1) / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
