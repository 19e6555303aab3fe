// mutant: t_split 0 is ahead: >= instead of >
// task: children_on_ray
// caught by: children-behind
// says: eye on the plane
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split >= 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
