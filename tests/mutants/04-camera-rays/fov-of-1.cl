// mutant: 1 is passed for fov
// task: primary_ray
// caught by: ray-transform
// says: fov of 1
    const float3 p = pixel_on_display(x, y, width, height, 1.0f);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(p.x * to_float3(camera.right) + p.y * to_float3(camera.up) +
                              p.z * to_float3(camera.forward));
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
