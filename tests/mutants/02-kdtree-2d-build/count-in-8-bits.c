// mutant: the number of circles is cut to 8 bits
// task: is_leaf
// caught by: is_leaf-count
// says: cut to 8 bits
    const u8 n = (u8)n_circles;
    return level >= limits.maxDepth || n <= limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
