// mutant: the origin is forgotten
// task: children_on_ray
// caught by: children-cases
// says: without the origin
    *t_split = node.split_pos * inverse;
    (void)origin;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
