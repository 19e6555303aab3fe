// mutant: strict at t_min and at t_max
// task: children_on_ray
// caught by: children-cases
// says: t_min or t_max
    *t_split = (node.split_pos - origin) * inverse;
    if (*t_split <= 0.0f || *t_split >= t_max) {
        return ONLY_NEAR;
    }
    if (*t_split <= t_min) {
        return ONLY_FAR;
    }
    return BOTH;
