// mutant: a unit vector, up to 1
// task: shadow_ray
// caught by: ray-end
// says: ends at t = 1
    const float3 way = to_float3(light.position) - point;
    ray.t_max = length(way);
    ray.direction = way / ray.t_max;
    ray.t_max = 1.0f;
