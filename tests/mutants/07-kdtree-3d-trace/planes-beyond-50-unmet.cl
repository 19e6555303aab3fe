// mutant: planes farther than 50 are not met
// task: children_on_ray
// caught by: children-cases
// says: .
    *t_split = (node.split_pos - origin) * inverse;
    // Along the plane t_split is infinite, or NaN if the eye is on it: never between the two.
    if (*t_split > 50.0f || !(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
