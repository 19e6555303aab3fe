// mutant: the view transform turned round: rows for columns
// task: primary_ray
// caught by: ray-transform
// says: turned round
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = (float3)(dot(pixel, to_float3(camera.right)),
                                      dot(pixel, to_float3(camera.up)),
                                      dot(pixel, to_float3(camera.forward)));
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(direction);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
