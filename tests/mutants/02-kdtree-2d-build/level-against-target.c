// mutant: levels are compared with the other limit
// task: is_leaf
// caught by: is_leaf-depth
// says: limit of another
    return level >= limits.targetElementsPerNode ||
           n_circles <= (u32)limits.targetElementsPerNode || n_failed >= MAX_FAILED_SPLITS;
