// mutant: the discriminant is halved, not its root
// task: intersect_textbook
// caught by: textbook-outside
// says: divided by 4
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = -2.0f * dot(o, ray.direction);
    const float disc = b * b - 4.0f * (dot(o, o) - sphere.radius * sphere.radius);
    return nearest_root(b / 2.0f, disc / 2.0f, sphere.radius, ray.t_min);
