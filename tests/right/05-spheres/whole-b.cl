// right: the whole b of the textbook, with its factors 2 and 4
// task: intersect_textbook
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = 2.0f * dot(ray.direction, o);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    const float disc = b * b - 4.0f * c;
    return nearest_root(-0.5f * b, 0.25f * disc, sphere.radius, ray.t_min);
