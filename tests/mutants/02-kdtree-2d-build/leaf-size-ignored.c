// mutant: the number of circles does not stop the splitting
// task: is_leaf
// caught by: is_leaf-count
// says: found 0, expected 1
    (void)n_circles;
    return level >= limits.maxDepth || n_failed >= MAX_FAILED_SPLITS;
