// mutant: a slip of the pen: up for forward
// task: primary_ray
// caught by: ray-transform
// says: axes is there twice
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 up = to_float3(camera.up);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(pixel.x * to_float3(camera.right) + pixel.y * up + pixel.z * up);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
