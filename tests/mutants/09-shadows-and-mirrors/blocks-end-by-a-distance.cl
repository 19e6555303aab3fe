// mutant: hits less than a ten-thousandth before the end do not count
// task: leaf_blocks
// caught by: blocks-edges
// says: near to the end
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (t < ray.t_max - 1e-4f) {
            return 1;
        }
    }
