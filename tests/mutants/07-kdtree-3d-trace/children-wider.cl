// mutant: the part is wider by an epsilon
// task: children_on_ray
// caught by: children-cases
// says: outside of the part
    const float t = (node.split_pos - origin) * inverse;
    *t_split = t;
    if (!(t > 0.0f && t <= t_max + 1e-4f)) {
        return ONLY_NEAR;
    }
    return t < t_min - 1e-4f ? ONLY_FAR : BOTH;
