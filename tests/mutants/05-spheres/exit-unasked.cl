// mutant: the exit is taken without asking t_min
// task: nearest_root
// caught by: root-inside
// says: exit counts beyond
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float h = sqrt(disc);
    return radius > 0.0f && b - h > t_min ? b - h : b + h;
