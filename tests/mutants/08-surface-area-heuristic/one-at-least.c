// mutant: a child without spheres is thought to cost a test
// task: split_cost
// caught by: cost-edges
// says: costs no test
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST *
               (surface_area(lower) * (n_lower > 0 ? n_lower : 1) +
                surface_area(higher) * (n_higher > 0 ? n_higher : 1)) /
               surface_area(box);
