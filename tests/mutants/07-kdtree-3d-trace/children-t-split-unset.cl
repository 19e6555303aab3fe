// mutant: t_split is not handed out
// task: children_on_ray
// caught by: children-cases
// says: t_split is not set
    const float t = (node.split_pos - origin) * inverse;
    (void)t_split;
    if (!(t > 0.0f && t <= t_max)) {
        return ONLY_NEAR;
    }
    return t < t_min ? ONLY_FAR : BOTH;
