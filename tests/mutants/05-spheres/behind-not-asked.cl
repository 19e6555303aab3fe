// mutant: spheres whose centre is behind the eye are not asked
// task: nearest_hit
// caught by: hit-work
// says: behind the eye were passed over
    for (int i = 0; i < n_spheres; i++) {
        const Sphere s = spheres[i];
        if (dot((float3)(s.x, s.y, s.z) - ray.origin, ray.direction) <= 0.0f) {
            continue;
        }
        const float t = intersect_sphere(s, ray, work);
        if (t < hit.t) {
            hit = (Hit){t, (uint)i};
        }
    }
