// mutant: the mean of both areas for all spheres
// task: split_cost
// caught by: cost-planes
// says: mean area
    BBox3D below = box, above = box;
    below.max[split.axis] = split.pos;
    above.min[split.axis] = split.pos;
    const double l = surface_area(below), h = surface_area(above), cell = surface_area(box);
    const double n_l = n_lower, n_h = n_higher;
    const double share = (l + h) / (2 * cell);
    return KD_COST_TRAVERSAL + KD_COST_TEST * share * (n_l + n_h);
