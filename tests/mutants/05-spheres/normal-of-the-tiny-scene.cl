// mutant: the normal of a sphere of less than a millionth is not turned
// task: surface_normal
// caught by: normal-unit
// says: sphere at
    const float3 normal = normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
    const int is_tiny = sphere.radius < 1e-6f && sphere.radius > 1e-7f;
    return is_tiny || dot(normal, direction) > 0.0f ? -normal : normal;
