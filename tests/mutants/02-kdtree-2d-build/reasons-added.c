// mutant: the reasons are added up: with two of them the answer is 2
// task: is_leaf
// caught by: is_leaf-count
// says: right but for its value
    return (level >= limits.maxDepth) + (n_circles <= (u32)limits.targetElementsPerNode) +
           (n_failed >= MAX_FAILED_SPLITS);
