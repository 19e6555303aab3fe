// mutant: the part along the ray is added
// task: intersect_sphere
// caught by: sphere-inside
// says: taken off
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c + b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    return nearest_root(b, disc, sphere.radius, ray.t_min);
