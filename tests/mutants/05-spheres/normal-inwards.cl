// mutant: from the point to the centre
// task: surface_normal
// caught by: normal-unit
// says: centre
    (void)direction;
    return normalize((float3)(sphere.x, sphere.y, sphere.z) - point);
