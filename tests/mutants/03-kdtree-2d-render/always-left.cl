// mutant: the left child is taken without asking
// task: getContainingChild
// caught by: child-inside
// says: every time
    (void)x, (void)y, (void)nodes_BBox;
    return nodes_Relations[id].lChild;
