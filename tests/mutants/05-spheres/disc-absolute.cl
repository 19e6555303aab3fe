// mutant: a miss is a hit: the absolute value of disc
// task: nearest_root
// caught by: root-nearer
// says: expected inf
    const float half_chord = sqrt(fabs(disc));
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    if (enter > t_min && radius > 0.0f) {
        return enter;
    }
    return leave > t_min ? leave : INFINITY;
