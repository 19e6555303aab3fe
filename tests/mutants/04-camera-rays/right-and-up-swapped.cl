// mutant: right and up are swapped
// task: primary_ray
// caught by: ray-transform
// says: swapped
    const float3 p = pixel_on_display(x, y, width, height, camera.fov);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(p.x * to_float3(camera.up) + p.y * to_float3(camera.right) +
                              p.z * to_float3(camera.forward));
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
