// mutant: the sign of the radius does not matter
// task: nearest_root
// caught by: root-inside
// says: negative radius
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    (void)radius;
    if (t_near > t_min) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
