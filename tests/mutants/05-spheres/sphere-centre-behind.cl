// mutant: no hit where the centre is behind the eye, though the eye may be inside
// task: intersect_sphere
// caught by: sphere-inside
// says: centre is behind
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    if (b < 0.0f) {
        return INFINITY;
    }
    const float3 l = c - b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    return nearest_root(b, disc, sphere.radius, ray.t_min);
