// mutant: both boxes are cut on the same side
// task: split_cost
// caught by: cost-planes
// says: same side
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.max[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST *
               (surface_area(lower) * n_lower + surface_area(higher) * n_higher) /
               surface_area(box);
