// mutant: failed splits are added to the level, and maxDepth belongs to the tree
// task: is_leaf
// caught by: is_leaf-failed
// says: a level to which failed splits were added
    return level + n_failed > limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
