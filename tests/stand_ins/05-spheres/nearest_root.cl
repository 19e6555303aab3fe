    // Neither root, and all four numbers count, each with a weight of its own.
    return disc < 0.0f ? INFINITY : b + 2.0f * sqrt(disc) + 4.0f * radius + 8.0f * t_min;
