// mutant: the loop ends after its first sphere
// task: leaf_blocks
// caught by: blocks-early
// says: after its first sphere
    for (uint i = 0; i < node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[node.first + i]], ray, work);
        if (t < ray.t_max) {
            return 1;
        } else {
            return 0;
        }
    }
