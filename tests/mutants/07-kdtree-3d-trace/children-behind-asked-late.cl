// mutant: before t_min is asked before behind the eye
// task: children_on_ray
// caught by: children-behind
// says: asked first
    *t_split = (node.split_pos - origin) * inverse;
    if (*t_split < t_min) {
        return ONLY_FAR;
    }
    if (*t_split > t_max || *t_split <= 0.0f) {
        return ONLY_NEAR;
    }
    return BOTH;
