// mutant: b is not squared
// task: intersect_sphere
// caught by: sphere-near
// says: b is not squared
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float disc = sphere.radius * sphere.radius - dot(c, c) + b;
    return nearest_root(b, disc, sphere.radius, ray.t_min);
