// mutant: limits 16 and 8, whatever is given
// task: is_leaf
// caught by: is_leaf-depth
// says: 16 and 8
    (void)limits;
    return level >= 16 || n_circles <= 8 || n_failed >= MAX_FAILED_SPLITS;
