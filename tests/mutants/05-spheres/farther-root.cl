// mutant: where the ray leaves, always
// task: nearest_root
// caught by: root-nearer
// says: farther
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    return t_far > t_min ? t_far : INFINITY;
