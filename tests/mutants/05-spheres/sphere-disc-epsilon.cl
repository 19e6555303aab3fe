// mutant: a chord that is short does not count
// task: intersect_sphere
// caught by: sphere-far-small
// says: makes a miss
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    if (disc < 1e-3f) {
        return INFINITY;
    }
    return nearest_root(b, disc, sphere.radius, ray.t_min);
