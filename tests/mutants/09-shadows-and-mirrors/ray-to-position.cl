// mutant: the position is taken for the way
// task: shadow_ray
// caught by: ray-direction
// says: position, not the way
    const float3 way = to_float3(light.position);
    ray.t_max = length(way);
    ray.direction = way / ray.t_max;
