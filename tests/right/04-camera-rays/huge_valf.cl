// right: HUGE_VALF is infinite in OpenCL C
// task: primary_ray
    const float3 p = pixel_on_display(x, y, width, height, camera.fov);
    const float3 way = p.x * to_float3(camera.right) + p.y * to_float3(camera.up) +
                       to_float3(camera.forward);
    ray = (Ray){to_float3(camera.eye), normalize(way), 0.0f, HUGE_VALF};
