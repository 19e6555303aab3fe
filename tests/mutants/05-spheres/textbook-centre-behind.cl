// mutant: no hit where the centre is behind the eye, though the eye may be inside
// task: intersect_textbook
// caught by: textbook-inside
// says: centre is behind
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float half_b = dot(o, ray.direction);
    if (half_b > 0.0f) {
        return INFINITY;
    }
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    return nearest_root(-half_b, half_b * half_b - c, sphere.radius, ray.t_min);
