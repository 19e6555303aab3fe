// mutant: the higher child alone gets a cell of its own
// task: split_cost
// caught by: cost-planes
// says: lower child.s box is not cut
    BBox3D higher = box;
    higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (surface_area(box) * n_lower + surface_area(higher) * n_higher) /
               surface_area(box);
