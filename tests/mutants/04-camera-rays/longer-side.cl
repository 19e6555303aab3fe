// mutant: fov is the width of the longer side
// task: pixel_on_display
// caught by: display-aspect
// says: longer side
    const float pixel = fov / (float)max(width, height);
    return (float3)(((float)x + 0.5f - 0.5f * (float)width) * pixel,
                    (0.5f * (float)height - (float)y - 0.5f) * pixel, 1.0f);
