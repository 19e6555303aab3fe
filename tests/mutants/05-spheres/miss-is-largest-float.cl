// mutant: a miss is the largest float
// task: nearest_root
// caught by: root-nearer
// says: largest float
    float t = MAXFLOAT;
    if (disc >= 0.0f) {
        const float h = sqrt(disc);
        if (b + h > t_min) {
            t = b + h;
        }
        if (b - h > t_min && radius > 0.0f) {
            t = b - h;
        }
    }
    return t;
