// mutant: a plane behind the eye is as far ahead
// task: children_on_ray
// caught by: children-behind
// says: found
    *t_split = fabs((node.split_pos - origin) * inverse);
    if (!(*t_split > 0.0f && *t_split <= t_max)) {
        return ONLY_NEAR;
    }
    return *t_split < t_min ? ONLY_FAR : BOTH;
