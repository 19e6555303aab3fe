// mutant: 16 bits are to hold the id of a sphere
// task: leaf_blocks
// caught by: blocks-before
// says: longest leaf
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const ushort id = (ushort)sphere_ids[i];
        if (intersect_sphere(spheres[id], ray, work) < ray.t_max) {
            return 1;
        }
    }
