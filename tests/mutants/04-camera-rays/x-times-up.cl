// mutant: up is multiplied by x
// task: primary_ray
// caught by: ray-transform
// says: up was multiplied by x
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 across = pixel.x * (to_float3(camera.right) + to_float3(camera.up));
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(across + pixel.z * to_float3(camera.forward));
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
