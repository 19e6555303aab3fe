// mutant: the way is the sum of light and point
// task: shadow_ray
// caught by: ray-direction
// says: added
    const float3 way = point + to_float3(light.position);
    ray.t_max = distance(to_float3(light.position), point);
    ray.direction = normalize(way);
