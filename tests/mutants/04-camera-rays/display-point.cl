// mutant: the point on the display for the direction
// task: direction_color
// caught by: color-picture
// says: differ
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    color = 0.5f * pixel + 0.5f;
