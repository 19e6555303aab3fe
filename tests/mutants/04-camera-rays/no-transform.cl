// mutant: the direction stays in the camera's axes
// task: primary_ray
// caught by: ray-transform
// says: camera's axes
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = pixel;
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(direction);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
