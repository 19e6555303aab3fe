// mutant: the colours are encoded for a screen, with a power of 1 / 2.2
// task: direction_color
// caught by: color-picture
// says: gamma
// looks: gamma
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = 0.5f * ray.direction + 0.5f;
    color = pow(color, 1.0f / 2.2f);
