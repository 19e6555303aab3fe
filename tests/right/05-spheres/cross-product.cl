// right: the distance between centre and ray as the length of a cross product
// task: intersect_sphere
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float3 l = cross(c, ray.direction);
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    return nearest_root(dot(c, ray.direction), disc, sphere.radius, ray.t_min);
