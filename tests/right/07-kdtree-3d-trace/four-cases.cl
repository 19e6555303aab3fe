// right: the cases one after the other; along the plane first
// task: children_on_ray
    const float distance = node.split_pos - origin;
    if (isinf(inverse) || distance == 0.0f) {
        return ONLY_NEAR;
    }
    const float t = distance * inverse;
    *t_split = t;
    if (t <= 0.0f) {
        return ONLY_NEAR;
    }
    if (t > t_max) {
        return ONLY_NEAR;
    }
    if (t < t_min) {
        return ONLY_FAR;
    }
    return BOTH;
