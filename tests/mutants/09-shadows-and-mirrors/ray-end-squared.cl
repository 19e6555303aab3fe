// mutant: the distance is not rooted
// task: shadow_ray
// caught by: ray-end
// says: square of the distance
    const float3 way = to_float3(light.position) - point;
    ray.t_max = dot(way, way);
    ray.direction = normalize(way);
