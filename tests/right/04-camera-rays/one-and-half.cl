// right: plus one, then halved
// task: direction_color
    color = (primary_ray(x, y, width, height, camera).direction + 1.0f) / 2.0f;
