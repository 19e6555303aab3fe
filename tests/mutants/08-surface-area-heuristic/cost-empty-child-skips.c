// mutant: with an empty child the other one counts in full
// task: split_cost
// caught by: cost-planes
// says: in full
    BBox3D below = box, above = box;
    below.max[split.axis] = split.pos;
    above.min[split.axis] = split.pos;
    const double l = surface_area(below), h = surface_area(above), cell = surface_area(box);
    const double n_l = n_lower, n_h = n_higher;
    const double full = KD_COST_TRAVERSAL + KD_COST_TEST * (n_l + n_h);
    return n_lower * (double)n_higher == 0
               ? full
               : KD_COST_TRAVERSAL + KD_COST_TEST * (l / cell * n_l + h / cell * n_h);
