// mutant: equal to t_min is taken for before
// task: children_on_ray
// caught by: children-cases
// says: exactly at t_min
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split <= t_min ? ONLY_FAR : BOTH;
