// mutant: two hits less than 1e-4 apart count as equally far
// task: search_leaf
// caught by: leaf-ids
// says: epsilon
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t - 1e-4f || (fabs(t - hit->t) <= 1e-4f && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
