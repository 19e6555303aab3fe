// mutant: a sphere with a negative radius is no sphere
// task: nearest_root
// caught by: root-inside
// says: seen from inside
    if (disc < 0.0f || radius < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    if (enter > t_min) {
        return enter;
    }
    return leave > t_min ? leave : INFINITY;
