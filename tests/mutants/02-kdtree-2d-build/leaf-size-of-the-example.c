// mutant: the leaf size of the lecture's example, 1, is written into the code
// task: is_leaf
// caught by: tree-limits
// says: split, expected a leaf
    return level >= limits.maxDepth || n_circles <= 1 || n_failed >= MAX_FAILED_SPLITS;
