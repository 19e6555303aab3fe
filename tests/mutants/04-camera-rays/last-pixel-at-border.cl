// mutant: the first and the last pixel stand on the borders
// task: pixel_on_display
// caught by: display-middle
// says: on the borders|as many steps as pixels
    const float pixel_size = fov / (width - 1);
    const float right = (x - 0.5f * (width - 1)) * pixel_size;
    const float up = (0.5f * (height - 1) - y) * pixel_size;
    return (float3)(right, up, 1.0f);
