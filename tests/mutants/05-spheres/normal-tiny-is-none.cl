// mutant: a tiny vector has no direction
// task: surface_normal
// caught by: normal-unit
// says: found
    const float3 v = point - (float3)(sphere.x, sphere.y, sphere.z);
    const float3 normal = length(v) < 1e-9f ? (float3)(0.0f) : normalize(v);
    return dot(normal, direction) > 0.0f ? -normal : normal;
