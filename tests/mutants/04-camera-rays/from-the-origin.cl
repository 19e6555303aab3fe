// mutant: the ray begins at the origin
// task: primary_ray
// caught by: ray-limits
// says: eye
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = pixel.x * to_float3(camera.right) + pixel.y * to_float3(camera.up) +
                             pixel.z * to_float3(camera.forward);
    ray.origin = (float3)(0.0f);
    ray.direction = normalize(direction);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
