// mutant: the middle of the pixel in y, its border in x
// task: pixel_on_display
// caught by: display-middle
// says: in one direction
// looks: shifted-half
    const float pixel_size = fov / width;
    const float right = (x - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
