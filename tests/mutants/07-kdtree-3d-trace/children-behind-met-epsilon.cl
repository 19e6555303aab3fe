// mutant: a plane less than 1e-4 behind the eye counts as ahead
// task: children_on_ray
// caught by: children-behind
// says: epsilon
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > -1e-4f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
