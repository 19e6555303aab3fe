// mutant: the cost cut to a whole number
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: cut to a whole number
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           (i32)best_cost >= KD_COST_TEST * n_spheres;
