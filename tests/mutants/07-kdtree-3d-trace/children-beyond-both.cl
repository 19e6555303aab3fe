// mutant: t_far is not asked
// task: children_on_ray
// caught by: children-cases
// says: t_far did not count
    *t_split = (node.split_pos - origin) * inverse;
    if ((void)t_far, !(*t_split > 0.0f)) {
        return ONLY_NEAR;
    }
    return *t_split < t_near ? ONLY_FAR : BOTH;
