    // Neither root, and all four numbers count, each with a weight of its own.
    const float of_radius = 4.0f + (float)(NONCE % 16u), of_t_min = 8.0f + (float)(NONCE / 16u % 16u);
    return disc < 0.0f ? INFINITY : b + 2.0f * sqrt(disc) + of_radius * radius + of_t_min * t_min;
