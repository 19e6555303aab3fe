// mutant: levels up to maxDepth are leaves
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: in another way
    if (level <= limits.maxDepth) {
        return 1;
    }
    return n_spheres <= (u32)limits.targetElementsPerNode || best_cost >= KD_COST_TEST * n_spheres;
