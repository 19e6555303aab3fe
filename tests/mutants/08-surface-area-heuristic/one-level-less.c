// mutant: the level before maxDepth stays a leaf
// task: is_leaf_by_cost
// caught by: leaf-limits
// says: before maxDepth
    return level + 1 >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost >= KD_COST_TEST * n_spheres;
