// mutant: hits close to the point do not count
// task: shadow_ray
// caught by: ray-origin
// says: t_min is 0
    const float3 way = to_float3(light.position) - point;
    ray.t_max = length(way);
    ray.t_min = 0.001f;
    ray.direction = way / ray.t_max;
