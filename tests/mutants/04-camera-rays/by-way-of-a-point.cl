// mutant: the direction goes by way of a point: eye + d - eye loses d's digits
// task: primary_ray
// caught by: ray-transform
// says: far eye
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = pixel.x * to_float3(camera.right) + pixel.y * to_float3(camera.up) +
                             pixel.z * to_float3(camera.forward);
    const float3 eye = to_float3(camera.eye);
    const float3 on_display = eye + direction;
    ray.origin = eye;
    ray.direction = normalize(on_display - eye);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
