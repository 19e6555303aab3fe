// mutant: a plane less than 1e-4 beyond t_max is met
// task: children_on_ray
// caught by: children-cases
// says: epsilon
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max + 1e-4f)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
