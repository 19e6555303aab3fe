// mutant: from inside only negative radii are hit
// task: nearest_root
// caught by: root-inside
// says: second root
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float h = sqrt(disc);
    if (radius > 0.0f) {
        return b - h > t_min ? b - h : INFINITY;
    }
    return b + h > t_min ? b + h : INFINITY;
