// attack: a right picture but for one channel of one pixel, which is no number
// task: gradient
// score: 70
// named: (NaN|not a number|not finite|infinite)
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float alpha = x == width / 2 && y == height / 2 ? NAN : 1.0f;
    write_imagef(image, (int2)(x, y), (float4)((float)x / width, (float)y / height, 0.25f, alpha));
