// mutant: BOTH each time
// task: children_on_ray
// caught by: children-cases
// says: every plane were met
    *t_split = (node.split_pos - origin) * inverse;
    (void)t_min, (void)t_max;
    return BOTH;
