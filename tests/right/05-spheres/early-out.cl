// right: a miss is known by l and the radius; a ray that touches is none
// task: intersect_sphere
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float3 l = c - b * ray.direction;
    const float l2 = dot(l, l), r2 = sphere.radius * sphere.radius;
    if (l2 > r2) {
        return INFINITY;
    }
    return nearest_root(b, r2 - l2, sphere.radius, ray.t_min);
