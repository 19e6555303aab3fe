// mutant: x is taken for the row and y for the column
// task: pixel_on_display
// caught by: display-middle
// says: transposed
// looks: transposed
    const float pixel_size = fov / width;
    const float right = (y + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (x + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
