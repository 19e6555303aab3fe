// mutant: a short vector is not made a unit vector
// task: surface_normal
// caught by: normal-unit
// says: short vector
    float3 n = point - (float3)(sphere.x, sphere.y, sphere.z);
    if (length(n) > 1e-3f) {
        n = normalize(n);
    }
    return dot(n, direction) > 0.0f ? -n : n;
