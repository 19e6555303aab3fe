// mutant: the exit is asked for 0, not for t_min
// task: nearest_root
// caught by: root-t_min
// says: exit counts beyond t_min
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float h = sqrt(disc);
    if (radius > 0.0f && b - h > t_min) {
        return b - h;
    }
    return b + h > 0.0f ? b + h : INFINITY;
