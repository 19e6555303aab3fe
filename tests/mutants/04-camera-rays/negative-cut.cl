// mutant: negative parts are cut off
// task: direction_color
// caught by: color-picture
// says: cut off
    color = clamp(primary_ray(x, y, width, height, camera).direction, 0.0f, 1.0f);
