// mutant: (r - |l|) squared for the difference of squares
// task: intersect_sphere
// caught by: sphere-near
// says: never negative
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float h = sphere.radius - length(c - b * ray.direction);
    return nearest_root(b, h * h, sphere.radius, ray.t_min);
