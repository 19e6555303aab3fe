// mutant: x grows to the left
// task: pixel_on_display
// caught by: display-sides
// says: mirrored
// looks: mirrored-x
    const float pixel_size = fov / width;
    const float right = (0.5f * width - (x + 0.5f)) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
