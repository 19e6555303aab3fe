// mutant: a direction of less than 1e-4 counts as 0: the ray never meets the plane
// task: children_on_ray
// caught by: children-parallel
// says: epsilon
    *t_split = (node.split_pos - origin) * inverse;
    if (fabs(inverse) > 1e4f || !(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
