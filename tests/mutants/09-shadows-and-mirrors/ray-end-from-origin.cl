// mutant: the light's distance from the scene's origin
// task: shadow_ray
// caught by: ray-end
// says: distance from the origin
    const float3 way = to_float3(light.position) - point;
    ray.direction = normalize(way);
    ray.t_max = length(to_float3(light.position));
