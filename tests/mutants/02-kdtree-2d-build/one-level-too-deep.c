// mutant: levels are taken to count from 0: level > maxDepth
// task: is_leaf
// caught by: is_leaf-depth
// says: found 0, expected 1
    return level > limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
