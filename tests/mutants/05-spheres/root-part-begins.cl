// mutant: from inside the hit is where the part begins
// task: nearest_root
// caught by: root-inside
// says: where the ray leaves
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float h = sqrt(disc);
    if (b + h <= t_min) {
        return INFINITY;
    }
    return radius < 0.0f ? b + h : fmax(b - h, t_min);
