// mutant: > for >=
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: gains nothing
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost > KD_COST_TEST * n_spheres;
