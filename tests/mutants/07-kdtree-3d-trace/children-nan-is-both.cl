// mutant: NaN is neither behind nor beyond: it falls to both
// task: children_on_ray
// caught by: children-parallel
// says: NaN
    *t_split = (node.split_pos - origin) * inverse;
    if (*t_split <= 0.0f || *t_split > t_max) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
