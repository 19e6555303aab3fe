// mutant: looks at the flag too late: one sphere more
// task: leaf_blocks
// caught by: blocks-early
// says: one sphere more
    int blocked = 0;
    for (uint i = node.first; i < node.first + node.n_spheres; i++) {
        const float t = intersect_sphere(spheres[sphere_ids[i]], ray, work);
        if (blocked) {
            return 1;
        }
        blocked = t < ray.t_max;
    }
    return blocked;
