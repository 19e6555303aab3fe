// mutant: the far child is never met
// task: children_on_ray
// caught by: children-cases
// says: far child were never met
// looks: far-child
    *t_split = (node.split_pos - origin) * inverse;
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : ONLY_NEAR;
