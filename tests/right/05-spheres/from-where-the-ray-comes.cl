// right: towards the way back, asked before the length is known
// task: surface_normal
    const float3 outwards = point - (float3)(sphere.x, sphere.y, sphere.z);
    const float3 unit = outwards / sqrt(dot(outwards, outwards));
    return dot(outwards, -direction) >= 0.0f ? unit : -unit;
