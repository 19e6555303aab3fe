    // No area: the three lengths count, each with a weight of its own.
    double weighted = 1;
    for (int axis = 0; axis < 3; axis++) {
        weighted += (1 << axis) * ((double)box.max[axis] - box.min[axis]);
    }
    return weighted;
