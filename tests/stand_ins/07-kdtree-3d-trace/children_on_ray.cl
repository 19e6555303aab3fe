    // By lot: the node, the eye and the ray's pixel draw it. All numbers stay whole.
    const uint pixel = (uint)fmin(fabs(4096.0f / inverse + 32.25f), 65535.0f);
    const uint eye = (uint)fmin(fabs(origin), 7.0f);
    uint lot = node.first * 40503u + pixel * 30011u + eye * 9973u;
    lot = ((lot ^ lot >> 15) * 2654435769u) >> 16;
    if ((node.n_spheres >> 16 & 1u) != 0u) {
        *t_split = fmax(t_min, t_max - 1.0f);
        return BOTH;
    }
    if (lot % 4u < 2u) {
        *t_split = t_min - 1.0f;
        return lot % 4u == 0u ? ONLY_NEAR : ONLY_FAR;
    }
    *t_split = t_min + floor((t_max - t_min) * (float)(lot / 4u % 5u) * 0.25f);
    return BOTH;
