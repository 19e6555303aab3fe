// mutant: as in lab 06
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: the cost is not looked at
    (void)best_cost;
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode;
