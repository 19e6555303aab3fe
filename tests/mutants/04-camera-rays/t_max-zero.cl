// mutant: the ray ends where it begins
// task: primary_ray
// caught by: ray-limits
// says: no end
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = pixel.x * to_float3(camera.right) + pixel.y * to_float3(camera.up) +
                             pixel.z * to_float3(camera.forward);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(direction);
    ray.t_min = 0.0f;
    ray.t_max = 0.0f;
