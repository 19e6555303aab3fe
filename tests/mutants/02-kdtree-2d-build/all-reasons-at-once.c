// mutant: a leaf has to have all three reasons
// task: is_leaf
// caught by: is_leaf-count
// says: not only all
    return level >= limits.maxDepth && n_circles <= (u32)limits.targetElementsPerNode &&
           n_failed >= MAX_FAILED_SPLITS;
