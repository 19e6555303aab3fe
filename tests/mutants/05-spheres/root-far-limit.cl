// mutant: hits beyond 1e20 are dropped
// task: nearest_root
// caught by: root-nearer
// says: makes a miss
    if (disc < 0.0f || b > 1e20f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    if (b - half_chord > t_min && radius > 0.0f) {
        return b - half_chord;
    }
    return b + half_chord > t_min ? b + half_chord : INFINITY;
