// mutant: the half is added before halving
// task: direction_color
// caught by: color-picture
// says: before halving
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = 0.5f * (ray.direction + 0.5f);
