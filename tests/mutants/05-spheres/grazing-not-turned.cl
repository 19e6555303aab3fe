// mutant: a grazing normal is not turned
// task: surface_normal
// caught by: normal-inside
// says: however small
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(normal, direction) > 1e-4f ? -normal : normal;
