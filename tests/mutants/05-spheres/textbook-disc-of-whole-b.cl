// mutant: the discriminant is four times as large
// task: intersect_textbook
// caught by: textbook-outside
// says: four times
    const float3 o = ray.origin - (float3)(sphere.x, sphere.y, sphere.z);
    const float b = 2.0f * dot(o, ray.direction);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    return nearest_root(-b / 2.0f, b * b - 4.0f * c, sphere.radius, ray.t_min);
