// mutant: no limit of spheres
// task: is_leaf_by_cost
// caught by: leaf-limits
// says: targetElementsPerNode is not looked at
    return level >= limits.maxDepth || best_cost >= KD_COST_TEST * n_spheres;
