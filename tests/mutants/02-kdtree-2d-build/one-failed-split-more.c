// mutant: one more split may fail: > instead of >=
// task: is_leaf
// caught by: is_leaf-failed
// says: found 0, expected 1
    return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed > MAX_FAILED_SPLITS;
