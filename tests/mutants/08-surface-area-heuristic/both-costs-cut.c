// mutant: both costs are cut to whole numbers
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: cut to a whole number
    if (level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
        best_cost == INFINITY) {
        return 1;
    }
    return (long)best_cost >= (long)(KD_COST_TEST * n_spheres);
