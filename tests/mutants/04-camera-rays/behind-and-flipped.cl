// mutant: z is -1 and y counts from above
// task: pixel_on_display
// caught by: display-sides
// says: at z = 1
    const float size = fov / width;
    return (float3)((x + 0.5f - 0.5f * width) * size, (y + 0.5f - 0.5f * height) * size, -1.0f);
