// mutant: x is blue and z is red
// task: direction_color
// caught by: color-channels
// says: red and blue
// looks: channels-swapped
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = (0.5f * ray.direction + 0.5f).zyx;
