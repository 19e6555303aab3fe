// mutant: the row is written as x and the column as y
// task: gradient
// caught by: gradient-picture
// says: transposed
// looks: transposed
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)x / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(y, x), (float4)(red, green, 0.25f, 1.0f));
