// mutant: a display of width 1, at distance 1 / fov
// task: pixel_on_display
// caught by: display-sides
// says: 1 wide
    const float w = (float)width;
    return (float3)(((float)x + 0.5f) / w - 0.5f, (0.5f * (float)height - (float)y - 0.5f) / w,
                    1.0f / fov);
