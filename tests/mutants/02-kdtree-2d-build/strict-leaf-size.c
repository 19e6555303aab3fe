// mutant: a node with just targetElementsPerNode circles is split: < instead of <=
// task: is_leaf
// caught by: is_leaf-count
// says: found 0, expected 1
    return level >= limits.maxDepth || n_circles < (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
