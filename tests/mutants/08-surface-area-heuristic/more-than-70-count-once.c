// mutant: more than 70 spheres beyond a plane count as one
// task: split_cost
// caught by: cost-planes
// says: .
    BBox3D lower = box, higher = box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const double n_expected =
        (surface_area(lower) * n_lower +
         surface_area(higher) * (n_higher > 70 && n_higher < 200 ? 1 : n_higher)) /
        surface_area(box);
    return KD_COST_TRAVERSAL + KD_COST_TEST * n_expected;
