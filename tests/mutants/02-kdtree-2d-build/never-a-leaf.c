// mutant: no node ever stays a leaf
// task: is_leaf
// caught by: tree-limits
// says: gave up
    (void)level, (void)n_circles, (void)limits;
    return 0;
