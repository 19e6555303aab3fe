// right: a factor of 1 or -1 from the dot product
// task: surface_normal
    const float3 centre = (float3)(sphere.x, sphere.y, sphere.z);
    const float3 outwards = normalize(point - centre);
    return outwards * copysign(1.0f, -dot(outwards, direction));
