// mutant: always split
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: expected 1
    (void)level, (void)n_spheres, (void)best_cost, (void)limits;
    return 0;
