// mutant: a split that leaves a child empty is thought to cost no step
// task: split_cost
// caught by: cost-edges
// says: a child is empty, too
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return (n_lower == 0 || n_higher == 0 ? 0 : KD_COST_TRAVERSAL) +
           KD_COST_TEST * (surface_area(lower) * n_lower + surface_area(higher) * n_higher) /
               surface_area(box);
