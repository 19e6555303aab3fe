// mutant: hits nearer than 0.001 are dropped
// task: search_leaf
// caught by: leaf-nearest
// says: close to the eye
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t > 0.001f && (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere))) {
            hit->t = t;
            hit->sphere = id;
        }
    }
