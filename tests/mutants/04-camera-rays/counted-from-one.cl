// mutant: columns and rows are counted from 1
// task: pixel_on_display
// caught by: display-middle
// says: shifted by one pixel
// looks: shifted-one
    const float pixel_size = fov / width;
    const float right = (x + 1 + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - ((y + 1) + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
