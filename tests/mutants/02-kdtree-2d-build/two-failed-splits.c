// mutant: stops after two failed splits
// task: is_leaf
// caught by: is_leaf-failed
// says: two failed splits
    enum { AXES = 2 };
    return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode || n_failed >= AXES;
