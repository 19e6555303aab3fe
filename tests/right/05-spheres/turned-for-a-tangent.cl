// right: a tangent comes from neither side; here its normal is turned
// task: surface_normal
    const float3 outwards = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(outwards, direction) < 0.0f ? outwards : -outwards;
