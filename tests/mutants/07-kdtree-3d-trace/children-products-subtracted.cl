// mutant: the products are subtracted: far from the origin their digits are lost
// task: children_on_ray
// caught by: children-cases
// says: digits
    *t_split = node.split_pos * inverse - origin * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
