// mutant: half of the number of spheres as a whole number
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: cut to a whole number
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost >= n_spheres / 2;
