// mutant: the length of the unit vector
// task: shadow_ray
// caught by: ray-end
// says: ends at t = 1
    const float3 way = to_float3(light.position) - point;
    ray.direction = normalize(way);
    ray.t_max = length(ray.direction);
