// mutant: the entry must be beyond t_min by an epsilon
// task: nearest_root
// caught by: root-t_min
// says: no epsilon
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    if (b - half_chord > t_min + 1e-6f && radius > 0.0f) {
        return b - half_chord;
    }
    return b + half_chord > t_min ? b + half_chord : INFINITY;
