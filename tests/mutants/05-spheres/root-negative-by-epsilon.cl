// mutant: a radius is negative when it is less than a millionth below 0
// task: nearest_root
// caught by: root-inside
// says: radius -2
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    if (b - half_chord > t_min && radius > -1e-6f) {
        return b - half_chord;
    }
    return b + half_chord > t_min ? b + half_chord : INFINITY;
