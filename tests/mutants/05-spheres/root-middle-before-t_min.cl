// mutant: no hit where the middle lies before t_min, though the exit is beyond
// task: nearest_root
// caught by: root-t_min
// says: t_min makes a miss
    if (disc < 0.0f || (b > 0.0f && b < t_min)) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    if (b - half_chord > t_min && radius > 0.0f) {
        return b - half_chord;
    }
    return b + half_chord > t_min ? b + half_chord : INFINITY;
