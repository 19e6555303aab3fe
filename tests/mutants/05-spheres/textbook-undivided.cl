// mutant: both roots without their division by 2
// task: intersect_textbook
// caught by: textbook-outside
// says: twice as far
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = -2.0f * dot(o, ray.direction);
    return nearest_root(b, b * b - 4.0f * (dot(o, o) - sphere.radius * sphere.radius),
                        sphere.radius, ray.t_min);
