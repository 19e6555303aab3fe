// mutant: half the width in whole numbers
// task: pixel_on_display
// caught by: display-middle
// says: odd width or height
    const float pixel_size = fov / width;
    const float right = (x + 0.5f - width / 2) * pixel_size;
    const float up = (height / 2 - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
