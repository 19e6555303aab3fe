// mutant: what stands behind the light casts a shadow, too
// task: shadow_ray
// caught by: ray-end
// says: no end
    ray.direction = normalize(to_float3(light.position) - point);
    ray.t_max = INFINITY;
