// mutant: red is divided by height
// task: gradient
// caught by: gradient-picture
// says: red divided by height
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float2 color = (float2)(x, y) / height;
    write_imagef(image, (int2)(x, y), (float4)(color, 0.25f, 1.0f));
