// mutant: as long as the way, up to 1
// task: shadow_ray
// caught by: ray-direction
// says: not a unit vector
    ray.direction = to_float3(light.position) - point;
    ray.t_max = 1.0f;
