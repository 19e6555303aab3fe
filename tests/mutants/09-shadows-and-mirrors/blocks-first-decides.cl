// mutant: only the first sphere is asked
// task: leaf_blocks
// caught by: blocks-before
// says: first sphere decides
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        return intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max;
    }
