// mutant: the ray of one pixel of every picture goes backwards
// task: primary_ray
// caught by: ray-transform
// says: pixel \(7, 7\)
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = pixel.x * to_float3(camera.right) + pixel.y * to_float3(camera.up) +
                             pixel.z * to_float3(camera.forward);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(x == 7 && y == 7 ? -direction : direction);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
