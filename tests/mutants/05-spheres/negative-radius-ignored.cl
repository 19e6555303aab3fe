// mutant: the sign of the radius does not matter
// task: nearest_root
// caught by: root-inside
// says: negative radius
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    (void)radius;
    if (enter > t_min) {
        return enter;
    }
    return leave > t_min ? leave : INFINITY;
