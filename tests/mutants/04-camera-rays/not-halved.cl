// mutant: the half is added, and the direction not halved
// task: direction_color
// caught by: color-picture
// says: only the half
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = ray.direction + 0.5f;
