// right: the share of the picture first, the display's size last
// task: pixel_on_display
    const float across = (x + 0.5f) / width;
    const float down = (y + 0.5f) / height;
    const float display_height = fov * height / width;
    return (float3)((across - 0.5f) * fov, (0.5f - down) * display_height, 1.0f);
