// mutant: b and b² - c where half of b belongs
// task: intersect_textbook
// caught by: textbook-outside
// says: b is twice as large
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float half_b = dot(o, ray.direction);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    return nearest_root(-2.0f * half_b, 4.0f * half_b * half_b - c, sphere.radius, ray.t_min);
