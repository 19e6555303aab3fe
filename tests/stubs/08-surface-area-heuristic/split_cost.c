    // No cost: squares of the two counts, each with a weight that a nonce draws, to which every bit of
    // the cell and of the plane counts. It is 1 or 2, so that often planes cost the same.
    const double numbers[] = {split.pos, box.min[0], box.min[1], box.min[2],
                              box.max[0], box.max[1], box.max[2]};
    unsigned long long drawn = NONCE + split.axis;
    for (int i = 0; i < 7; i++) {
        const union {
            double number;
            unsigned long long bits;
        } side = {0.0 + numbers[i]};
        drawn = (drawn ^ side.bits) * 0x9e3779b97f4a7c15u;
        drawn ^= drawn >> 29;
    }
    const double of_lower = 1 + (drawn >> 63), of_higher = 1 + (drawn >> 62) % 2u;
    return of_lower * n_lower * n_lower + of_higher * n_higher * n_higher;
