// mutant: divided by the radius, turned as it should be
// task: surface_normal
// caught by: normal-unit
// says: divided by the radius
    const float3 n = (point - (float3)(sphere.x, sphere.y, sphere.z)) / fabs(sphere.radius);
    return dot(n, direction) > 0.0f ? -n : n;
