// right: the length by a root of our own
// task: shadow_ray
    const float3 way = to_float3(light.position) - point;
    const float size = sqrt(dot(way, way));
    ray.direction = way * (1.0f / size);
    ray.t_max = size;
