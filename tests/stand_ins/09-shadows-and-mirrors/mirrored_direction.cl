    // Every ray leaves along the normal.
    return normal;
