// mutant: a hit must lie well beyond t_min
// task: nearest_root
// caught by: root-t_min
// says: no epsilon
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    const float epsilon = 1e-4f;
    if (t_near > t_min + epsilon && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min + epsilon ? t_far : INFINITY;
