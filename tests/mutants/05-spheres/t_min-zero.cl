// mutant: 0 for t_min
// task: nearest_root
// caught by: root-t_min
// says: found
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    (void)t_min;
    if (t_near > 0.0f && radius > 0.0f) {
        return t_near;
    }
    return t_far > 0.0f ? t_far : INFINITY;
