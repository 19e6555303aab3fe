// mutant: the outer pixels stand on the borders, in both directions
// task: pixel_on_display
// caught by: display-middle
// says: on the borders
    const float u = (float)x / (float)(width - 1) - 0.5f, v = 0.5f - (float)y / (float)(height - 1);
    return (float3)(u * fov, v * fov * (float)height / (float)width, 1.0f);
