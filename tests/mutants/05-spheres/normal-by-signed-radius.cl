// mutant: divided by the radius, and not turned
// task: surface_normal
// caught by: normal-inside
// says: whose sign
    const float3 n = (point - (float3)(sphere.x, sphere.y, sphere.z)) / sphere.radius;
    return n;
