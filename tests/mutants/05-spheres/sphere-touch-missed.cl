// mutant: an early out loses rays that touch
// task: intersect_sphere
// caught by: sphere-near
// says: touches
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    if (length(l) >= fabs(sphere.radius)) {
        return INFINITY;
    }
    return nearest_root(b, sphere.radius * sphere.radius - dot(l, l), sphere.radius, ray.t_min);
