// mutant: a miss is a hit: the absolute value of disc
// task: nearest_root
// caught by: root-nearer
// says: a negative disc is a miss
    const float half_chord = sqrt(fabs(disc));
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
