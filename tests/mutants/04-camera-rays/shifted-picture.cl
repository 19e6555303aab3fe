// mutant: columns counted from 1
// task: direction_color
// caught by: color-picture
// says: shifted by one pixel
// looks: shifted-one
    const Ray ray = primary_ray(x + 1, y, width, height, camera);
    color = 0.5f * ray.direction + 0.5f;
