// mutant: spheres larger than 10^10 and farther than 10^11 are not hit
// task: intersect_sphere
// caught by: sphere-near
// says: sphere at
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    if (sphere.radius > 1e10f && b > 2e12f && fabs(ray.direction.x) > 0.01f) {
        return INFINITY;
    }
    return nearest_root(b, disc, sphere.radius, ray.t_min);
