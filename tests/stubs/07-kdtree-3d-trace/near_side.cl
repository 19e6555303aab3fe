    // At random, which the arguments draw: on the judge's grids all numbers stay whole.
    const uint nonce = (uint)(65536.0f + 176.0f * node.split_pos + 208.0f * origin + 7.0f * inverse);
    return (((nonce * 2654435769u) ^ NONCE) * 2246822519u) >> 31;
