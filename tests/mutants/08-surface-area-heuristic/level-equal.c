// mutant: a level beyond maxDepth is split
// task: is_leaf_by_cost
// caught by: leaf-limits
// says: beyond maxDepth
    return level == limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost >= KD_COST_TEST * n_spheres;
