// right: the costs as a ratio, where the number is not 0
// task: is_leaf_by_cost
    if (n_spheres == 0 || level >= limits.maxDepth) {
        return 1;
    }
    return n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost / KD_COST_TEST >= (double)n_spheres;
