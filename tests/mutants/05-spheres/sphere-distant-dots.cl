// mutant: b is a difference of two dot products of places
// task: intersect_sphere
// caught by: sphere-near
// says: far from it
    const float3 centre = {sphere.x, sphere.y, sphere.z};
    const float b = dot(centre, ray.direction) - dot(ray.origin, ray.direction);
    const float3 l = centre - ray.origin - b * ray.direction;
    return nearest_root(b, sphere.radius * sphere.radius - dot(l, l), sphere.radius, ray.t_min);
