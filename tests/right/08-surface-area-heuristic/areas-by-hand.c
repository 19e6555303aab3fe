// right: the two areas from the face that is cut and its border
// task: split_cost
    const u32 a = (split.axis + 1) % 3, b = (split.axis + 2) % 3;
    const double u = (double)box.max[a] - box.min[a], v = (double)box.max[b] - box.min[b];
    const double whole = (double)box.max[split.axis] - box.min[split.axis];
    const double below = (double)split.pos - box.min[split.axis];
    const double above = (double)box.max[split.axis] - split.pos;
    const double face = u * v, border = u + v;
    return KD_COST_TRAVERSAL + KD_COST_TEST *
                                   ((face + border * below) * n_lower +
                                    (face + border * above) * n_higher) /
                                   (face + border * whole);
