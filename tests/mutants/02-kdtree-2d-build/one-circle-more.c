// mutant: one circle too many still makes a leaf
// task: is_leaf
// caught by: is_leaf-count
// says: one circle more
    return level >= limits.maxDepth || n_circles < (u32)limits.targetElementsPerNode + 2 ||
           n_failed >= MAX_FAILED_SPLITS;
