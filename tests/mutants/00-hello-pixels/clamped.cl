// mutant: work-items outside the picture draw its border once more
// task: gradient
// caught by: gradient-padding
// says: once more
    const int x = min((int)get_global_id(0), width - 1);
    const int y = min((int)get_global_id(1), height - 1);
    write_imagef(image, (int2)(x, y), (float4)((float)x / width, (float)y / height, 0.25f, 1.0f));
