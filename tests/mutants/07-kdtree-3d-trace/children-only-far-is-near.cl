// mutant: a plane crossed before the node leaves the near child
// task: children_on_ray
// caught by: children-cases
// says: far child, not the near
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_NEAR : BOTH;
