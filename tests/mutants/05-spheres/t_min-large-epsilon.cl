// mutant: a hit must be a hundredth beyond t_min
// task: nearest_root
// caught by: root-t_min
// says: no epsilon
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min + 0.01f && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min + 0.01f ? t_far : INFINITY;
