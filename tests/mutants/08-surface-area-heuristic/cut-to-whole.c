// mutant: the expected number of tests as a whole number
// task: split_cost
// caught by: cost-planes
// says: cut to a whole number
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST *
               (u32)((surface_area(lower) * n_lower + surface_area(higher) * n_higher) /
                     surface_area(box));
