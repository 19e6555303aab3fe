// mutant: hits behind t_min count
// task: nearest_root
// caught by: root-t_min
// says: beyond t_min
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    (void)t_min;
    return radius > 0.0f ? t_near : t_far;
