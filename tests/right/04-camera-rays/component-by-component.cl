// right: each component by itself, divided by the length
// task: primary_ray
    const float3 p = pixel_on_display(x, y, width, height, camera.fov);
    const Vec3 r = camera.right;
    const Vec3 u = camera.up;
    const Vec3 f = camera.forward;
    const float3 way = (float3)(r.x * p.x + u.x * p.y + f.x * p.z,
                                r.y * p.x + u.y * p.y + f.y * p.z,
                                r.z * p.x + u.z * p.y + f.z * p.z);
    ray.t_max = INFINITY;
    ray.t_min = 0.0f;
    ray.direction = way / length(way);
    ray.origin = (float3)(camera.eye.x, camera.eye.y, camera.eye.z);
