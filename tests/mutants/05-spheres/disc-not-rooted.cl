// mutant: disc itself for its root
// task: nearest_root
// caught by: root-nearer
// says: found
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = disc;
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    if (enter > t_min && radius > 0.0f) {
        return enter;
    }
    return leave > t_min ? leave : INFINITY;
