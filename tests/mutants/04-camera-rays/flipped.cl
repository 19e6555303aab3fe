// mutant: y grows downwards
// task: pixel_on_display
// caught by: display-sides
// says: flipped
// looks: flipped-y
    const float pixel_size = fov / width;
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const float up = (y + 0.5f - 0.5f * height) * pixel_size;
    return (float3)(right, up, 1.0f);
