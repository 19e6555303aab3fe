    // No cost: squares of the two counts, and a fine for planes in the lower quarter of the side.
    const double min = box.min[split.axis], max = box.max[split.axis];
    const double of_lower = 1 + LOT % 64u / 64.0;
    const double n_squared = of_lower * n_lower * n_lower + 2.0 * n_higher * n_higher;
    return n_squared + (split.pos < min + (max - min) / 4 ? 5 : 0);
