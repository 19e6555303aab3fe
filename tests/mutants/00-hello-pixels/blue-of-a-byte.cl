// mutant: blue is 64 / 255
// task: gradient
// caught by: gradient-picture
// says: but for blue
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height)
        return;
    write_imagef(image, (int2)(x, y), (float4)((float)x / width, (float)y / height, 64 / 255.0f, 1.0f));
