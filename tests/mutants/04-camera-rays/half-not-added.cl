// mutant: halved, but not moved: half of the colours are negative
// task: direction_color
// caught by: color-picture
// says: half were not added
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = 0.5f * ray.direction;
