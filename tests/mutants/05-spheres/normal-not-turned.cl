// mutant: the normal always points outwards
// task: surface_normal
// caught by: normal-inside
// says: turned
    (void)direction;
    return normalize(point - (float3)(sphere.x, sphere.y, sphere.z));
