// mutant: failed splits are compared with maxDepth
// task: is_leaf
// caught by: is_leaf-failed
// says: however many
return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
       n_failed > limits.maxDepth;
