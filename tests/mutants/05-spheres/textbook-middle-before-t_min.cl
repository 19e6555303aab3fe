// mutant: no hit where the middle lies before t_min, though the exit is beyond
// task: intersect_textbook
// caught by: textbook-inside
// says: t_min makes a miss
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = -dot(o, ray.direction);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    if (b < ray.t_min && c > 0.0f) {
        return INFINITY;
    }
    return nearest_root(b, b * b - c, sphere.radius, ray.t_min);
