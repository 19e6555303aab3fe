// mutant: where no child has a sphere, the step costs nothing
// task: split_cost
// caught by: cost-edges
// says: both children are empty
    if (n_lower == 0 && n_higher == 0) {
        return 0;
    }
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (surface_area(lower) * n_lower + surface_area(higher) * n_higher) /
               surface_area(box);
