// mutant: rows counted from below
// task: direction_color
// caught by: color-picture
// says: flipped
// looks: flipped-y
    const Ray ray = primary_ray(x, height - 1 - y, width, height, camera);
    color = 0.5f * ray.direction + 0.5f;
