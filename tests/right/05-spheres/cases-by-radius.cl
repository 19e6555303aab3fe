// right: the radius decides first, then t_min
// task: nearest_root
    if (!(disc >= 0.0f)) {
        return INFINITY;
    }
    const float root = sqrt(disc);
    float t = radius < 0.0f ? b + root : b - root;
    if (t <= t_min) {
        t = b + root;
    }
    return t > t_min ? t : INFINITY;
