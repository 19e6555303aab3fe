// mutant: hits behind t_min count
// task: nearest_root
// caught by: root-t_min
// says: beyond t_min
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    (void)t_min;
    return radius > 0.0f ? enter : leave;
