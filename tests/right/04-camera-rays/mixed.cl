// right: mixed from 0 and 1, one channel after the other
// task: direction_color
    const float3 d = primary_ray(x, y, width, height, camera).direction;
    color.x = mix(0.5f, 1.0f, d.x);
    color.y = mix(0.5f, 1.0f, d.y);
    color.z = mix(0.5f, 1.0f, d.z);
