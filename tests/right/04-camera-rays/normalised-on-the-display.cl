// right: made a unit vector in the camera's axes, then turned
// task: primary_ray
    const float3 seen = normalize(pixel_on_display(x, y, width, height, camera.fov));
    float3 direction = seen.z * to_float3(camera.forward);
    direction += seen.y * to_float3(camera.up);
    direction += seen.x * to_float3(camera.right);
    ray = (Ray){to_float3(camera.eye), direction, 0.0f, INFINITY};
