// right: t_split is handed out where it is used, for BOTH
// task: children_on_ray
    const float t = (node.split_pos - origin) * inverse;
    if (t > 0.0f && t < t_min) {
        return ONLY_FAR;
    }
    if (t > 0.0f && t <= t_max) {
        *t_split = t;
        return BOTH;
    }
    return ONLY_NEAR;
