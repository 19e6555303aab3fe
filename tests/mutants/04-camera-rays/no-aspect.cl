// mutant: the display is as high as wide: pixels are no squares
// task: pixel_on_display
// caught by: display-aspect
// says: squares
    const float pixel_size = fov / width;
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * (fov / height);
    return (float3)(right, up, 1.0f);
