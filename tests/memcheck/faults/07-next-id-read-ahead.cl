// fault: the next id is read ahead of its turn, also behind the last leaf's
// lab: 07-kdtree-3d-trace
// task: search_leaf
// says: reads sphere_ids
    uint next = sphere_ids[node.first];
    for (uint i = 0; i < node.n_spheres; i++) {
        const uint id = next;
        next = sphere_ids[node.first + i + 1];  // HERE
        const float t = intersect_sphere(spheres[id], ray, work);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
