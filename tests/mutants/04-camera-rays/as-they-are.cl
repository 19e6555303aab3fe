// mutant: directions unmapped: half of them are negative
// task: direction_color
// caught by: color-picture
// says: differ
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = ray.direction;
