// mutant: inside and before are swapped
// task: children_on_ray
// caught by: children-cases
// says: more than one
    *t_split = (node.split_pos - origin) * inverse;
    if (*t_split > 0.0f && *t_split <= t_max) {
        return *t_split < t_min ? BOTH : ONLY_FAR;
    }
    return ONLY_NEAR;
