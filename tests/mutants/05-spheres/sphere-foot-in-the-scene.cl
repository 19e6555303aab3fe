// mutant: the foot is a point in the scene's coordinates: far from the origin digits are lost
// task: intersect_sphere
// caught by: sphere-near
// says: far from it
    const float3 centre = {sphere.x, sphere.y, sphere.z};
    const float b = dot(centre - ray.origin, ray.direction);
    const float3 foot = ray.origin + b * ray.direction;
    const float3 l = centre - foot;
    return nearest_root(b, sphere.radius * sphere.radius - dot(l, l), sphere.radius, ray.t_min);
