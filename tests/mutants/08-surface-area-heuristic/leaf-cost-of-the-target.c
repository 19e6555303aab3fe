// mutant: a leaf costs as if it had targetElementsPerNode spheres
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: something else
    const double leaf_cost = KD_COST_TEST * limits.targetElementsPerNode;
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost >= leaf_cost;
