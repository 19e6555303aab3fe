// mutant: the tree ends on level maxDepth - 1
// task: is_leaf
// caught by: is_leaf-depth
// says: found 1, expected 0
    return level + 1 >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
