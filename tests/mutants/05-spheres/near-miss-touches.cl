// mutant: a near miss is taken for touching
// task: nearest_root
// caught by: root-nearer
// says: expected inf
    if (disc < -1e-4f) {
        return INFINITY;
    }
    const float half_chord = sqrt(fmax(disc, 0.0f));
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
