// mutant: t_split without the inverse
// task: children_on_ray
// caught by: children-cases
// says: not yet times
    const float t = node.split_pos - origin;
    *t_split = t;
    return t > 0.0f && t <= t_max ? (t >= t_min ? BOTH : ONLY_FAR) : ONLY_NEAR;
