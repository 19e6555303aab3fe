// mutant: the eye is added to the direction
// task: primary_ray
// caught by: ray-transform
// says: eye was added
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = to_float3(camera.eye) + pixel.x * to_float3(camera.right) +
                             pixel.y * to_float3(camera.up) + pixel.z * to_float3(camera.forward);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(direction);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
