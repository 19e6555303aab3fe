// mutant: disc itself for its root
// task: nearest_root
// caught by: root-nearer
// says: root was forgotten
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = disc;
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
