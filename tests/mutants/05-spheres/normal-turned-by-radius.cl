// mutant: turned only where the radius is negative
// task: surface_normal
// caught by: normal-inside
// says: radius' sign
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    (void)direction;
    return sphere.radius < 0.0f ? -normal : normal;
