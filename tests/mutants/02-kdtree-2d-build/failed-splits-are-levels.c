// mutant: failed splits are added to the level
// task: is_leaf
// caught by: is_leaf-failed
// says: added
    return level + n_failed >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode || n_failed >= MAX_FAILED_SPLITS;
