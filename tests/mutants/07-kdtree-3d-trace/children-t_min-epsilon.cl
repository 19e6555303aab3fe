// mutant: a plane less than 1e-4 before t_min is met
// task: children_on_ray
// caught by: children-cases
// says: epsilon
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min - 1e-4f ? ONLY_FAR : BOTH;
