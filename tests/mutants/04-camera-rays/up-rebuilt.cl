// mutant: forward x right, which points down, for up
// task: primary_ray
// caught by: ray-transform
// says: up and down
    const float3 p = pixel_on_display(x, y, width, height, camera.fov);
    const float3 r = to_float3(camera.right), f = to_float3(camera.forward);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(p.x * r + p.y * cross(f, r) + p.z * f);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
