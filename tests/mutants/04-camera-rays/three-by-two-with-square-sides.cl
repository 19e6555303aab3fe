// mutant: pictures between square and twice as wide as high have no square pixels
// task: pixel_on_display
// caught by: display-aspect
// says: pixel
    const float pixel_size = fov / width;
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const int is_wide = width > height && width < 2 * height;
    const float up = (0.5f * height - (y + 0.5f)) * (is_wide ? fov / height : pixel_size);
    return (float3)(right, up, 1.0f);
