// mutant: l . l - r²
// task: intersect_sphere
// caught by: sphere-near
// says: disc has the wrong
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    const float disc = dot(l, l) - sphere.radius * sphere.radius;
    return nearest_root(b, disc, sphere.radius, ray.t_min);
