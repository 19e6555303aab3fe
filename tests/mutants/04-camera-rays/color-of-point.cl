// mutant: the eye is added to the direction
// task: direction_color
// caught by: color-picture
// says: eye were added
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = 0.5f * (ray.origin + ray.direction) + 0.5f;
