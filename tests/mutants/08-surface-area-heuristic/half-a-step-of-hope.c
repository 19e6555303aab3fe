// mutant: a split that is dearer by a little is tried
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: expected 1
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost >= 1.01 * KD_COST_TEST * n_spheres;
