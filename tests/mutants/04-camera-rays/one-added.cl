// mutant: 1 is added and nothing halved
// task: direction_color
// caught by: color-picture
// says: 1 were added
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = ray.direction + 1.0f;
