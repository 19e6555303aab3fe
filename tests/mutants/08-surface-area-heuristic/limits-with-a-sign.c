// mutant: the number of spheres is compared with a sign
// task: is_leaf_by_cost
// caught by: leaf-limits
// says: as an int
    return level >= limits.maxDepth || (int)n_spheres <= limits.targetElementsPerNode || best_cost >= KD_COST_TEST * n_spheres;
