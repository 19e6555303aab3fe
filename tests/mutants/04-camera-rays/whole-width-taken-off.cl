// mutant: the width is not halved
// task: pixel_on_display
// caught by: display-sides
// says: the middle is half of it
    const float pixel_size = fov / width;
    const float right = (x + 0.5f - width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
