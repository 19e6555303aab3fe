    float3 p;
    p.x = fov * (float)((x + 3 * width) % 17 - 8) * 0.125f;
    p.y = fov * (float)((y + 3 * height) % 17 - 8) * 0.125f;
    p.z = 1.0f;
    return p;
