// mutant: as if the sphere stood at the origin
// task: surface_normal
// caught by: normal-unit
// says: centre was forgotten
    (void)sphere;
    const float3 normal = normalize(point);
    return dot(normal, direction) > 0.0f ? -normal : normal;
