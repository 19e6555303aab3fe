// mutant: a disc below a hundredth is none
// task: nearest_root
// caught by: root-nearer
// says: compare it with 0
    if (disc < 1e-2f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
