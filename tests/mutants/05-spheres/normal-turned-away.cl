// mutant: the wrong side
// task: surface_normal
// caught by: normal-inside
// says: away from where
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(normal, direction) < 0.0f ? -normal : normal;
