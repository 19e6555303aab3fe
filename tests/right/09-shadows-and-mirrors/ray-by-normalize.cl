// right: normalize() and distance()
// task: shadow_ray
    const float3 to = (float3)(light.position.x, light.position.y, light.position.z);
    ray.direction = normalize(to - point);
    ray.t_max = distance(to, point);
