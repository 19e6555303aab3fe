// mutant: no hit when the ray enters behind the eye
// task: nearest_root
// caught by: root-inside
// says: second root
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(disc);
    const float t_near = b - half_chord;
    return t_near > t_min && radius > 0.0f ? t_near : INFINITY;
