// mutant: multiplied by the sign of the dot product, which is 0 for a tangent
// task: surface_normal
// caught by: normal-unit
// says: tangent
    const float3 n = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return -sign(dot(n, direction)) * n;
