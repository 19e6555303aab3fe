// mutant: the number of spheres for what they cost
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: not 1
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost >= n_spheres;
