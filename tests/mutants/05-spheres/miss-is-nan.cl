// mutant: a negative disc comes out as NaN
// task: nearest_root
// caught by: root-nearer
// says: has no root
    float t = b - sqrt(disc);
    if (radius < 0.0f || t <= t_min) {
        t = b + sqrt(disc);
    }
    if (t <= t_min) {
        return INFINITY;
    }
    return t;
