// mutant: a square is compared with a distance
// task: leaf_blocks
// caught by: blocks-before
// says: compared with a square
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t * t < ray.t_max) {
            return 1;
        }
    }
