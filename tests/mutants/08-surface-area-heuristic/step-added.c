// mutant: the step is added again
// task: is_leaf_by_cost
// caught by: leaf-cost
// says: counts once
    return level >= limits.maxDepth || n_spheres <= (u32)limits.targetElementsPerNode ||
           best_cost + KD_COST_TRAVERSAL >= KD_COST_TEST * n_spheres;
