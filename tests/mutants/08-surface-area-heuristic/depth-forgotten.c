// mutant: no limit of depth
// task: is_leaf_by_cost
// caught by: leaf-limits
// says: maxDepth is not looked at
    (void)level;
    return n_spheres <= (u32)limits.targetElementsPerNode || best_cost >= KD_COST_TEST * n_spheres;
