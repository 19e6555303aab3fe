// mutant: divided by the largest coordinate
// task: shadow_ray
// caught by: ray-direction
// says: its largest coordinate
    const float3 way = to_float3(light.position) - point;
    const float3 size = fabs(way);
    ray.t_max = fmax(size.x, fmax(size.y, size.z));
    ray.direction = way / ray.t_max;
