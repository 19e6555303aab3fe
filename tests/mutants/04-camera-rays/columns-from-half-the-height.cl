// mutant: the middle column is found with the height
// task: pixel_on_display
// caught by: display-sides
// says: other side's size
    const float pixel_size = fov / width;
    const float middle = 0.5f * height;
    return (float3)((x + 0.5f - middle) * pixel_size, (middle - y - 0.5f) * pixel_size, 1.0f);
