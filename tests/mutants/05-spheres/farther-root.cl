// mutant: where the ray leaves, always
// task: nearest_root
// caught by: root-nearer
// says: farther
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    return leave > t_min ? leave : INFINITY;
