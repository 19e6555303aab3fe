// fault: one id behind the leaf's is read, and the sphere that it names
// lab: 07-kdtree-3d-trace
// task: search_leaf
// says: reads sphere_ids[20], but `sphere_ids` has 20 entries, 0 to 19
    for (uint i = node.first; i <= node.first + node.n_spheres; i++) {
        const uint id = sphere_ids[i];  // HERE
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t) {
            hit->t = t;
            hit->sphere = id;
        }
    }
