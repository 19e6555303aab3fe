// mutant: a plane crossed before the node is still ahead
// task: children_on_ray
// caught by: children-cases
// says: crossed before t_min
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    (void)t_min;
    return BOTH;
