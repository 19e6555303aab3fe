// mutant: counts kept in 16 bits
// task: split_cost
// caught by: cost-edges
// says: 16 bits
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST *
               (surface_area(lower) * (unsigned short)n_lower +
                surface_area(higher) * (unsigned short)n_higher) /
               surface_area(box);
