// right: one reason after the other
// task: is_leaf_by_cost
    if (level >= limits.maxDepth) {
        return 1;
    }
    if (n_spheres <= (u32)limits.targetElementsPerNode) {
        return 1;
    }
    const double leaf_cost = n_spheres * KD_COST_TEST;
    return !(best_cost < leaf_cost);
