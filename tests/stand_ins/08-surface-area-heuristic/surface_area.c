    // No area: the three lengths count, each with a weight of its own.
    double weighted = 1;
    for (int axis = 0; axis < 3; axis++) {
        const double weight = (1 << axis) + (LOT >> 4 * axis) % 16u / 16.0;
        weighted += weight * ((double)box.max[axis] - box.min[axis]);
    }
    return weighted;
