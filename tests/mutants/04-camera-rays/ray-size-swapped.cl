// mutant: width and height are swapped in the call
// task: primary_ray
// caught by: ray-transform
// says: width and height
    const float3 p = pixel_on_display(x, y, height, width, camera.fov);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(p.x * to_float3(camera.right) + p.y * to_float3(camera.up) +
                              p.z * to_float3(camera.forward));
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
