// mutant: one pixel of every picture is as far to the right as the next
// task: pixel_on_display
// caught by: display-aspect
// says: pixel \(33, 21\)
    const float pixel_size = fov / width;
    const float right = (x + (x == 33 && y == 21 ? 1.5f : 0.5f) - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
