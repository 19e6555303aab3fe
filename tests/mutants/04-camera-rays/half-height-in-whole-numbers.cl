// mutant: half the height as a whole number
// task: pixel_on_display
// caught by: display-middle
// says: odd height
    const float pixel = fov / (float)width;
    return (float3)(((float)x + 0.5f - (float)width / 2.0f) * pixel,
                    ((float)(height / 2) - ((float)y + 0.5f)) * pixel, 1.0f);
