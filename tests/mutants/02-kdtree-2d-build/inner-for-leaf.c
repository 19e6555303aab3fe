// mutant: 1 for a node that is split
// task: is_leaf
// caught by: is_leaf-count
// says: 1 and 0 are swapped
    return level < limits.maxDepth && n_circles > (u32)limits.targetElementsPerNode &&
           n_failed < MAX_FAILED_SPLITS;
