// right: a probability for each child
// task: split_cost
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const double area = surface_area(box);
    const double p_lower = surface_area(lower) / area;
    const double p_higher = surface_area(higher) / area;
    return KD_COST_TRAVERSAL + KD_COST_TEST * n_lower * p_lower + KD_COST_TEST * n_higher * p_higher;
