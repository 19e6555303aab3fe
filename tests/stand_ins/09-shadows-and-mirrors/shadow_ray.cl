    // Along the axis on which the light is farthest, and no farther than that.
    const float3 way = to_float3(light.position) - point;
    const float3 size = fabs(way);
    ray.t_max = fmax(fmax(size.x, size.y), size.z);
    ray.direction = (float3)(size.x == ray.t_max ? sign(way.x) : 0.0f,
                             size.y == ray.t_max ? sign(way.y) : 0.0f,
                             size.z == ray.t_max ? sign(way.z) : 0.0f);
