// mutant: a grazing normal is turned only beyond a millionth
// task: surface_normal
// caught by: normal-inside
// says: however small
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(normal, direction) > 1e-7f ? -normal : normal;
