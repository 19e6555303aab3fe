// mutant: from the light to the point
// task: shadow_ray
// caught by: ray-origin
// says: starts at the light
    const float3 way = to_float3(light.position) - point;
    ray.t_max = length(way);
    ray.direction = -way / ray.t_max;
    ray.origin = to_float3(light.position);
