// mutant: half an odd size is rounded up
// task: pixel_on_display
// caught by: display-middle
// says: rounded up
    const float pixel = fov / (float)width;
    return (float3)(((float)x + 0.5f - (float)((width + 1) / 2)) * pixel,
                    ((float)((height + 1) / 2) - 0.5f - (float)y) * pixel, 1.0f);
