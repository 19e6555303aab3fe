// mutant: the display is divided into width + 1 pixels
// task: pixel_on_display
// caught by: display-middle
// says: as many steps as pixels
    const float pixel_size = fov / (width + 1);
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
