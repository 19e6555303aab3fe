// mutant: the number of circles is cut to 16 bits
// task: is_leaf
// caught by: is_leaf-count
// says: cut to 16 bits
    const unsigned short n = (unsigned short)n_circles;
    return level >= limits.maxDepth || n <= limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
