// right: r² - l² as (r - l) (r + l)
// task: intersect_sphere
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(ray.direction, c);
    const float l = length(c - b * ray.direction);
    const float r = fabs(sphere.radius);
    return nearest_root(b, (r - l) * (r + l), sphere.radius, ray.t_min);
