// mutant: the sum of the coordinates for the length
// task: shadow_ray
// caught by: ray-end
// says: sum of the way
    const float3 way = to_float3(light.position) - point;
    ray.t_max = fabs(way.x) + fabs(way.y) + fabs(way.z);
    ray.direction = normalize(way);
