// mutant: the higher part is divided by the higher area, the lower one counts all
// task: split_cost
// caught by: cost-planes
// says: one of these parts is another
    BBox3D below = box, above = box;
    below.max[split.axis] = split.pos;
    above.min[split.axis] = split.pos;
    const double l = surface_area(below), h = surface_area(above), cell = surface_area(box);
    const double n_l = n_lower, n_h = n_higher;
    return KD_COST_TRAVERSAL + KD_COST_TEST * (l * n_l + h * n_h) / h;
