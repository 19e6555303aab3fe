// mutant: weighed by edges, as for lines in a plane
// task: split_cost
// caught by: cost-planes
// says: edges
    double sides = 0;
    for (int axis = 0; axis < 3; axis++) {
        sides += (double)box.max[axis] - box.min[axis];
    }
    const double above = (double)box.max[split.axis] - split.pos;
    const double below = (double)split.pos - box.min[split.axis];
    return KD_COST_TRAVERSAL +
           KD_COST_TEST * ((sides - above) * n_lower + (sides - below) * n_higher) / sides;
