// attack: one colour, the mean of the right picture
// task: gradient
// score: 70
// named: differ
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x < width && y < height) {
        write_imagef(image, (int2)(x, y), (float4)(0.5f, 0.5f, 0.25f, 1.0f));
    }
