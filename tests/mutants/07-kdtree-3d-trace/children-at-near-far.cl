// mutant: equal to t_near is taken for before
// task: children_on_ray
// caught by: children-cases
// says: exactly at t_near
    *t_split = (node.split_pos - origin) * inverse;
    // Along the plane t_split is infinite, or not a number where the eye is on it: neither passes.
    if (!(*t_split > 0.0f && *t_split <= t_far)) {
        return ONLY_NEAR;
    }
    return *t_split <= t_near ? ONLY_FAR : BOTH;
