// mutant: a ray along the plane is sent to both children
// task: children_on_ray
// caught by: children-parallel
// says: infinite
    *t_split = (node.split_pos - origin) * inverse;
    if (isinf(inverse)) {
        return BOTH;
    }
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
