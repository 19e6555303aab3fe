// mutant: steps from the middle are halved as whole numbers
// task: pixel_on_display
// caught by: display-middle
// says: steps from the middle
    const float pixel = fov / (float)width;
    return (float3)((float)((2 * x + 1 - width) / 2) * pixel,
                    (float)((height - 2 * y - 1) / 2) * pixel, 1.0f);
