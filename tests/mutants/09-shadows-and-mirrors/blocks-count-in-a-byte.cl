// mutant: the leaf's count is kept in a byte
// task: leaf_blocks
// caught by: blocks-before
// says: found 0, expected 1
    const uchar n = (uchar)node.n_spheres;
    for (uint i = node.first; i < node.first + n; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max) {
            return 1;
        }
    }
