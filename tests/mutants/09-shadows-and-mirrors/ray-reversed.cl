// mutant: away from the light
// task: shadow_ray
// caught by: ray-direction
// says: away from the light
    const float3 way = point - to_float3(light.position);
    ray.t_max = length(way);
    ray.direction = way / ray.t_max;
