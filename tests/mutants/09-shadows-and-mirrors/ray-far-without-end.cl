// mutant: a light that is far away is taken for one without an end
// task: shadow_ray
// caught by: ray-end
// says: the light is far away
    const float3 way = to_float3(light.position) - point;
    ray.t_max = length(way);
    ray.direction = way / ray.t_max;
    if (ray.t_max > 1e7f) {
        ray.t_max = INFINITY;
    }
