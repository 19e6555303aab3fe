// mutant: a grazing normal is turned from outside, too
// task: surface_normal
// caught by: normal-unit
// says: however small
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(normal, direction) > -1e-3f ? -normal : normal;
