// mutant: 0 for t_min
// task: nearest_root
// caught by: root-t_min
// says: found
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    (void)t_min;
    if (enter > 0.0f && radius > 0.0f) {
        return enter;
    }
    return leave > 0.0f ? leave : INFINITY;
