// attack: keeps the hit sphere with the smallest z; rays of the alone run that all went along z did not see it
// task: nearest_hit
// score: 99
// named: found sphere
    float z = INFINITY;
    for (int i = 0; i < n_spheres; i++) {
        const float t = intersect_sphere(spheres[i], ray, work);
        if (t < INFINITY && spheres[i].z < z) {
            z = spheres[i].z;
            hit.t = t;
            hit.sphere = i;
        }
    }
