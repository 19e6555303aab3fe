// mutant: seen from outside, no hit where the middle lies before t_min, though the exit is beyond
// task: intersect_sphere
// caught by: sphere-inside
// says: t_min makes a miss
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    if (b < ray.t_min && dot(c, c) > sphere.radius * sphere.radius) {
        return INFINITY;
    }
    const float3 l = c - b * ray.direction;
    return nearest_root(b, sphere.radius * sphere.radius - dot(l, l), sphere.radius, ray.t_min);
