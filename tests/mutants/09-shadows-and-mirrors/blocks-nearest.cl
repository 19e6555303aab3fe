// mutant: looks for the nearest hit
// task: leaf_blocks
// caught by: blocks-early
// says: one in the way is enough
    Hit hit = {ray.t_max, NO_SPHERE};
    search_leaf(node, sphere_ids, spheres, ray, &hit, work);
    return hit.t < ray.t_max;
