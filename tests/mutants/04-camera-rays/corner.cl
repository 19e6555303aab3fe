// mutant: the pixel's corner for its middle
// task: pixel_on_display
// caught by: display-middle
// says: half a pixel
// looks: shifted-half
    const float pixel_size = fov / width;
    const float right = (x - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - y) * pixel_size;
    return (float3)(right, up, 1.0f);
