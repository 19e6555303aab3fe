// mutant: the point is made a unit vector
// task: pixel_on_display
// caught by: display-sides
// says: made a unit vector
    const float pixel = fov / (float)width;
    return normalize((float3)(((float)x + 0.5f - 0.5f * (float)width) * pixel,
                              (0.5f * (float)height - (float)y - 0.5f) * pixel, 1.0f));
