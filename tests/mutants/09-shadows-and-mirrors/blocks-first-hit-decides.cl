// mutant: the first sphere that is hit decides, behind the end, too
// task: leaf_blocks
// caught by: blocks-before
// says: that is hit decides
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t < INFINITY) {
            return t < ray.t_max;
        }
    }
