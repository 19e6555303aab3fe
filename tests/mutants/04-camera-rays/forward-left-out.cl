// mutant: forward is left out
// task: primary_ray
// caught by: ray-transform
// says: forward has no part
    const float3 p = pixel_on_display(x, y, width, height, camera.fov);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(p.x * to_float3(camera.right) + p.y * to_float3(camera.up));
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
