// mutant: 4 c with half of b
// task: intersect_textbook
// caught by: textbook-inside
// says: b² - 4 c
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = -dot(o, ray.direction), c = dot(o, o) - sphere.radius * sphere.radius;
    return nearest_root(b, b * b - 4.0f * c, sphere.radius, ray.t_min);
