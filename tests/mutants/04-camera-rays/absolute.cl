// mutant: the absolute value for the mapping
// task: direction_color
// caught by: color-picture
// says: absolute value
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = fabs(ray.direction);
