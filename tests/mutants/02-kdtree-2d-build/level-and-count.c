// mutant: level and count must both hold
// task: is_leaf
// caught by: is_leaf-depth
// says: one reason
    return (level >= limits.maxDepth && n_circles <= (u32)limits.targetElementsPerNode) || n_failed >= MAX_FAILED_SPLITS;
