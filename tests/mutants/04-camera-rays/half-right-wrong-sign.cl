// mutant: half a pixel of the wrong sign: x - 1/2
// task: pixel_on_display
// caught by: display-middle
// says: shifted by one pixel to the left: half a pixel has the wrong sign
// looks: shifted-one
    const float pixel_size = fov / width;
    const float right = (x - 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
