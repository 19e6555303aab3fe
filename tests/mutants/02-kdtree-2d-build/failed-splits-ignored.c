// mutant: failed splits do not stop the splitting
// task: is_leaf
// caught by: is_leaf-failed
// says: found 0, expected 1
    (void)n_failed;
    return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode;
