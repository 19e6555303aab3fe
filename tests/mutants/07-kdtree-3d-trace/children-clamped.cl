// mutant: t_split is moved into the part before it is compared
// task: children_on_ray
// caught by: children-cases
// says: moved into
    const float t = (node.split_pos - origin) * inverse;
    *t_split = clamp(t, t_min, t_max);
    if (!(t > 0.0f && *t_split <= t_max && t < INFINITY)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
