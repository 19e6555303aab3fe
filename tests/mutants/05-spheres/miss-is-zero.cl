// mutant: 0 for no hit
// task: nearest_root
// caught by: root-nearer
// says: found 0
    if (disc < 0.0f) {
        return 0.0f;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    if (enter > t_min && radius > 0.0f) {
        return enter;
    }
    return leave > t_min ? leave : 0.0f;
