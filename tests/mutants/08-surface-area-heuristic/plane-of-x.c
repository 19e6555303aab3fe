// mutant: the children are always cut across x
// task: split_cost
// caught by: cost-planes
// says: cut across x
    BBox3D lower = box, higher = box;
    lower.max[0] = higher.min[0] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (surface_area(lower) * n_lower + surface_area(higher) * n_higher) /
               surface_area(box);
