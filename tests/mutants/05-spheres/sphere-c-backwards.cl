// mutant: c from the centre to the eye
// task: intersect_sphere
// caught by: sphere-inside
// says: wrong sign
    const float3 c = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    return nearest_root(b, disc, sphere.radius, ray.t_min);
