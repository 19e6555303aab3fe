// mutant: the products are subtracted, the first one unrounded
// task: children_on_ray
// caught by: children-cases
// says: digits
    *t_split = fma(node.split_pos, inverse, -(origin * inverse));
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
