// mutant: t_max stays 0
// task: shadow_ray
// caught by: ray-end
// says: ends where it starts
    ray.direction = normalize(to_float3(light.position) - point);
