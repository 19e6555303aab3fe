// mutant: a ray that only touches the sphere misses it
// task: nearest_root
// caught by: root-nearer
// says: disc 0, .*found inf
    if (disc <= 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float enter = b - half_chord;
    const float leave = b + half_chord;
    if (enter > t_min && radius > 0.0f) {
        return enter;
    }
    return leave > t_min ? leave : INFINITY;
