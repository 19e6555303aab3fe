// mutant: hits within a hundred-thousandth of the end do not count
// task: leaf_blocks
// caught by: blocks-edges
// says: very near to the end
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < ray.t_max * 0.99998f) {
            return 1;
        }
    }
