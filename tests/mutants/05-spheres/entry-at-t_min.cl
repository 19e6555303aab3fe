// mutant: an entry at t_min counts
// task: nearest_root
// caught by: root-t_min
// says: an entry at t_min
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float h = sqrt(disc);
    if (radius > 0.0f && b - h >= t_min) {
        return b - h;
    }
    return b + h > t_min ? b + h : INFINITY;
