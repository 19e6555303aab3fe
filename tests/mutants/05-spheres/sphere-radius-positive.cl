// mutant: the radius handed on without its sign
// task: intersect_sphere
// caught by: sphere-inside
// says: negative radius
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    return nearest_root(b, disc, fabs(sphere.radius), ray.t_min);
