// mutant: height / width as whole numbers
// task: pixel_on_display
// caught by: display-aspect
// says: division of whole
    const float aspect = (float)(height / width);
    return (float3)((((float)x + 0.5f) / (float)width - 0.5f) * fov,
                    (0.5f - ((float)y + 0.5f) / (float)height) * fov * aspect, 1.0f);
