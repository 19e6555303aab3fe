// mutant: each part is made a unit vector
// task: primary_ray
// caught by: ray-transform
// says: by itself
    const float3 p = pixel_on_display(x, y, width, height, camera.fov);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(p.x * to_float3(camera.right)) +
                    normalize(p.y * to_float3(camera.up)) + to_float3(camera.forward);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
