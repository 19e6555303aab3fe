// mutant: half of the width is kept in an int
// task: pixel_on_display
// caught by: display-middle
// says: half of an odd width
    const int middle = width / 2;
    const float pixel_size = fov / width;
    const float right = (x - middle + 0.5f) * pixel_size;
    const float up = (0.5f * height - y - 0.5f) * pixel_size;
    return (float3)(right, up, 1.0f);
