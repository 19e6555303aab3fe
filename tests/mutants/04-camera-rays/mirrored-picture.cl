// mutant: columns counted from the right
// task: direction_color
// caught by: color-picture
// says: mirrored
// looks: mirrored-x
    const Ray ray = primary_ray(width - 1 - x, y, width, height, camera);
    color = 0.5f * ray.direction + 0.5f;
