// mutant: it ends before the light
// task: shadow_ray
// caught by: ray-end
// says: without an epsilon
    const float3 way = to_float3(light.position) - point;
    ray.t_max = length(way);
    ray.direction = way / ray.t_max;
    ray.t_max -= 0.001f;
