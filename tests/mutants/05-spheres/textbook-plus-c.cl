// mutant: half_b² + c
// task: intersect_textbook
// caught by: textbook-outside
// says: c has the wrong sign
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float half_b = dot(o, ray.direction);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    return nearest_root(-half_b, half_b * half_b + c, sphere.radius, ray.t_min);
