// mutant: a plane behind the eye counts as crossed before the node
// task: children_on_ray
// caught by: children-behind
// says: behind the eye
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
