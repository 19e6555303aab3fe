// mutant: only an empty node has few circles
// task: is_leaf
// caught by: is_leaf-count
// says: a number of your own
    return level >= limits.maxDepth || n_circles == 0 || n_failed >= MAX_FAILED_SPLITS;
