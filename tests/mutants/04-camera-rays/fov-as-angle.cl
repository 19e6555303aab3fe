// mutant: fov taken for an angle
// task: pixel_on_display
// caught by: display-middle
// says: angle
    const float pixel_size = 2.0f * tan(0.5f * fov) / width;
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
