// right: whole numbers of half pixels, scaled once
// task: pixel_on_display
    const float half_pixel = fov / (2 * width);
    const int right = 2 * x + 1 - width;
    const int up = height - 2 * y - 1;
    return (float3)(right * half_pixel, up * half_pixel, 1.0f);
