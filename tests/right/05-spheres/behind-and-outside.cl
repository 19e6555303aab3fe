// right: a sphere behind the eye is dismissed, but only where the eye is outside
// task: intersect_sphere
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    if (b < 0.0f && dot(c, c) > sphere.radius * sphere.radius) {
        return INFINITY;
    }
    const float3 l = c - b * ray.direction;
    const float disc = sphere.radius * sphere.radius - dot(l, l);
    return nearest_root(b, disc, sphere.radius, ray.t_min);
