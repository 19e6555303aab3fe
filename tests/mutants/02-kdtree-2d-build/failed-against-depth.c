// mutant: failed splits are compared with maxDepth
// task: is_leaf
// caught by: is_leaf-failed
// says: never make a leaf
return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
       n_failed > limits.maxDepth;
