// right: the leaving root first: without it there is no hit
// task: nearest_root
    if (disc < 0.0f || b + sqrt(disc) <= t_min) {
        return INFINITY;
    }
    const float t_far = b + sqrt(disc);
    const float t_near = b - sqrt(disc);
    return radius > 0.0f && t_near > t_min ? t_near : t_far;
