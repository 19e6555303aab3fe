// mutant: counts with a sign: huge ones become negative
// task: split_cost
// caught by: cost-edges
// says: 32 bits
    const i32 lower_tests = (i32)n_lower, higher_tests = (i32)n_higher;
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * (surface_area(lower) * lower_tests + surface_area(higher) * higher_tests) /
               surface_area(box);
