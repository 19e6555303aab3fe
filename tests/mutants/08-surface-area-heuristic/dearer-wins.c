// mutant: the comparison the wrong way round
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: other way round
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost < KD_COST_TEST * n_spheres;
