// mutant: the start is moved once more
// task: shadow_ray
// caught by: ray-origin
// says: starts beside the point
    const float3 way = to_float3(light.position) - point;
    ray.direction = normalize(way);
    ray.t_max = length(way);
    ray.origin = point + 0.001f * ray.direction;
