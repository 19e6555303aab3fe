// mutant: 8 bits are to hold the level
// task: is_leaf
// caught by: is_leaf-depth
// says: 8 bits
    const u8 low = (u8)level;
    return low >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
