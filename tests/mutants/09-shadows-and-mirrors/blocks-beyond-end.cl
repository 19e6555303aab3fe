// mutant: any hit will do, also behind the light
// task: leaf_blocks
// caught by: blocks-before
// says: behind the ray.s end blocks nothing
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        if (intersect_sphere(spheres[sphere_ids[i]], ray, work) < INFINITY) {
            return 1;
        }
    }
