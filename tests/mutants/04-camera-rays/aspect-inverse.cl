// mutant: width / height for height / width
// task: pixel_on_display
// caught by: display-aspect
// says: width / height
    const float u = ((float)x + 0.5f) / (float)width - 0.5f,
                v = 0.5f - ((float)y + 0.5f) / (float)height;
    return (float3)(u * fov, v * fov * ((float)width / (float)height), 1.0f);
