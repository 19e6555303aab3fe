// mutant: hits behind the end block
// task: leaf_blocks
// caught by: blocks-before
// says: inverted
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t > ray.t_max && t < INFINITY) {
            return 1;
        }
    }
