// right: a node is split when all three limits allow it
// task: is_leaf
    const int may_go_deeper = level < limits.maxDepth;
    const int is_crowded = (long long)n_circles > limits.targetElementsPerNode;
    const int may_help = n_failed < MAX_FAILED_SPLITS;
    return !(may_go_deeper && is_crowded && may_help);
