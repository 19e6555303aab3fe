// mutant: 0 for the ray's t_min
// task: intersect_textbook
// caught by: textbook-inside
// says: t_min is the ray's
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float half_b = dot(o, ray.direction);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    return nearest_root(-half_b, half_b * half_b - c, sphere.radius, 0.0f);
