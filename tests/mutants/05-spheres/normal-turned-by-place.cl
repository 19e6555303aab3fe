// mutant: the point's place decides which way it points
// task: surface_normal
// caught by: normal-unit
// says: place in the scene
    const float3 n = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    return dot(point, direction) > 0.0f ? -n : n;
