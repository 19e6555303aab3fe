// mutant: only maxDepth itself ends the tree, no level beyond it
// task: is_leaf
// caught by: is_leaf-depth
// says: everything beyond it
    return level == limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
