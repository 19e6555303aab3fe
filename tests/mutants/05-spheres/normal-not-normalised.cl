// mutant: the normal is as long as the radius
// task: surface_normal
// caught by: normal-unit
// says: unit
    const float3 normal = point - (float3)(sphere.x, sphere.y, sphere.z);
    return dot(normal, direction) > 0.0f ? -normal : normal;
