// mutant: divided by the radius, whose sign is taken to turn it
// task: surface_normal
// caught by: normal-inside
// says: found
    (void)direction;
    return (point - (float3)(sphere.x, sphere.y, sphere.z)) / sphere.radius;
