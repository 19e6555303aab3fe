// right: a node is split when both limits allow it
// task: is_leaf
    const int may_go_deeper = level < limits.maxDepth;
    const int is_crowded = (long long)n_circles > limits.targetElementsPerNode;
    return !(may_go_deeper && is_crowded);
