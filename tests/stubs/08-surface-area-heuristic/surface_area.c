    // No area: a number that a nonce draws, to which every bit of the six sides counts.
    const double numbers[] = {box.min[0], box.min[1], box.min[2],
                              box.max[0], box.max[1], box.max[2]};
    unsigned long long drawn = NONCE;
    for (int i = 0; i < 6; i++) {
        const union {
            double number;
            unsigned long long bits;
        } side = {0.0 + numbers[i]};
        drawn = (drawn ^ side.bits) * 0x9e3779b97f4a7c15u;
        drawn ^= drawn >> 29;
    }
    return 1 + (drawn >> 48) / 0x1p12;
