// mutant: ONLY_NEAR and ONLY_FAR are swapped
// task: children_on_ray
// caught by: children-cases
// says: swapped
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_FAR;
    }
    return *t_split < t_min ? ONLY_NEAR : BOTH;
