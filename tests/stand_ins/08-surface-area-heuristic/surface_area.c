    // No area: the three lengths count, each with a weight of its own.
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    return 1 + x + 2 * y + 4 * z;
