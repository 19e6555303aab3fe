// mutant: a tiny disc counts as 0: the hit is b
// task: nearest_root
// caught by: root-nearer
// says: found
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = disc < 1e-20f ? 0.0f : sqrt(disc);
    if (b - half_chord > t_min && radius > 0.0f) {
        return b - half_chord;
    }
    return b + half_chord > t_min ? b + half_chord : INFINITY;
