// right: a negative radius first, with its own question for t_min
// task: nearest_root
    if (disc < 0.0f) {
        return INFINITY;
    }
    const float t_far = b + sqrt(disc);
    if (t_far <= t_min) {
        return INFINITY;
    }
    if (radius < 0.0f) {
        return t_far;
    }
    const float t_near = b - sqrt(disc);
    return t_near > t_min ? t_near : t_far;
