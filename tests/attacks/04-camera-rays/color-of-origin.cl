// attack: wrong (colours the ray's origin), but in the stub's world origin and direction are equal
// task: direction_color
// score: 99
// named: differ
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = 0.5f * ray.origin + 0.5f;
