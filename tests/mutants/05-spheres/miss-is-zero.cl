// mutant: 0 for no hit
// task: nearest_root
// caught by: root-nearer
// says: not 0
    if (disc < 0.0f) {
        return 0.0f;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min ? t_far : 0.0f;
