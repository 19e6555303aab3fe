// mutant: directions unmapped: half of them are negative
// task: direction_color
// caught by: color-picture
// says: -1 to 1 becomes
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = ray.direction;
