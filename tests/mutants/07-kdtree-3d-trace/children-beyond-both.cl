// mutant: t_max is not asked
// task: children_on_ray
// caught by: children-cases
// says: t_max did not count
    *t_split = (node.split_pos - origin) * inverse;
    if ((void)t_max, !(*t_split > 0.0f)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
