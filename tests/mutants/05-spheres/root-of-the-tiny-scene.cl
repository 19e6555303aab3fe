// mutant: hits nearer than a 100000th do not count, but for those of a sphere as small as that
// task: nearest_root
// caught by: root-nearer
// says: b [0-9.]+e-0[5-9]
    if (disc < 0.0f || (b < 1e-5f && radius > 1e-8f && disc < 1e-12f && disc > 1e-16f)) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    const float t_far = b + half_chord;
    if (t_near > t_min && radius > 0.0f) {
        return t_near;
    }
    return t_far > t_min ? t_far : INFINITY;
