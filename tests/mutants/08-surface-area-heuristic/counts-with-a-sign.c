// mutant: counts become int
// task: split_cost
// caught by: cost-edges
// says: 32 bits
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = split.pos;
    higher.min[split.axis] = split.pos;
    const int lower_count = (int)n_lower, higher_count = (int)n_higher;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST *
               (surface_area(lower) * lower_count + surface_area(higher) * higher_count) /
               surface_area(box);
