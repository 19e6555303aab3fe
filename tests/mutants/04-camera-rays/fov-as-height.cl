// mutant: fov taken for the height
// task: pixel_on_display
// caught by: display-aspect
// says: height
    const float pixel_size = fov / height;
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
