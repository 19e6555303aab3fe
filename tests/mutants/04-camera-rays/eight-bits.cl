// mutant: colours are rounded down to 256 steps
// task: direction_color
// caught by: color-picture
// says: 8 bits
    color =
        floor((0.5f * primary_ray(x, y, width, height, camera).direction + 0.5f) * 255.0f) / 255.0f;
