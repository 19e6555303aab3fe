// mutant: the farther root of a negative radius counts behind the eye, too
// task: nearest_root
// caught by: root-inside
// says: radius is negative.*beyond t_min
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (radius < 0.0f) {
        return t_far;
    }
    if (t_near > t_min) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
