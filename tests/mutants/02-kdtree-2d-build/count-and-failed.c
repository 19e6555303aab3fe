// mutant: a node with few circles is a leaf only after failed splits
// task: is_leaf
// caught by: is_leaf-failed
// says: one reason is enough
// never says: were not asked for
    return level >= limits.maxDepth || (n_circles <= (u32)limits.targetElementsPerNode &&
                                        n_failed >= MAX_FAILED_SPLITS);
