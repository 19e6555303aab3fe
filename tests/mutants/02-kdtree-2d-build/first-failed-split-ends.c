// mutant: the first split that fails ends the splitting
// task: is_leaf
// caught by: is_leaf-failed
// says: found 1, expected 0
    return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed > 0;
