// mutant: the loop ends at the first sphere that is nearer than the hit so far
// task: search_leaf
// caught by: leaf-nearest
// says: first sphere that is hit
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
            break;
        }
    }
