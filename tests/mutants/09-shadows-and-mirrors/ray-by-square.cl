// mutant: divided by the square of the length
// task: shadow_ray
// caught by: ray-direction
// says: by its square
    const float3 way = to_float3(light.position) - point;
    ray.t_max = length(way);
    ray.direction = way / dot(way, way);
