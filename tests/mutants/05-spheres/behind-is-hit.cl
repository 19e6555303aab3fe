// mutant: the second root counts behind the eye, too
// task: nearest_root
// caught by: root-inside
// says: found
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    if (enter > t_min && radius > 0.0f) {
        return enter;
    }
    return leave;
