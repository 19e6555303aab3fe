// mutant: work-items outside the picture write too
// task: gradient
// caught by: gradient-padding
// says: outside
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    const float red = (float)x / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
