// mutant: the number of circles is compared with a sign
// task: is_leaf
// caught by: is_leaf-count
// says: with a sign
    return level >= limits.maxDepth || (int)n_circles <= limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
