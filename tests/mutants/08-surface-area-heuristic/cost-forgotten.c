// mutant: as in lab 06
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: cost does not end the splitting by itself
    (void)best_cost;
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode;
